// Numbers as the program prints them: four significant digits and the prefix that keeps them readable.
globalThis.isopatch = globalThis.isopatch || {};
(function (isopatch) {
  "use strict";

  const prefixes = [[1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "u"], [1e-9, "n"]];
  const lengthPrefixes = [[1, ""], [1e-2, "c"], [1e-3, "m"], [1e-6, "u"]];

  // Digits and exponent of a positive number; a tie goes to the even digit, as in C.
  function rounded(magnitude, digits) {
    let [mantissa, exponent] = magnitude.toExponential(digits - 1).split("e");
    const [exact, exactExponent] = magnitude.toExponential(60).split("e");
    const all = exact.replace(".", "");
    if (/^50*$/.test(all.slice(digits)) && Number(all[digits - 1]) % 2 === 0) {
      mantissa = all[0] + "." + all.slice(1, digits);
      exponent = exactExponent;
    }
    return [mantissa.replace(".", ""), Number(exponent)];
  }

  // The text of printf's %.<digits>g.
  isopatch.general = function (value, digits) {
    if (typeof value !== "number" || !Number.isFinite(value)) return "not finite";
    if (value === 0) return "0";
    const sign = value < 0 ? "-" : "";
    const [text, exponent] = rounded(Math.abs(value), digits);
    const strip = (number) => (number.includes(".") ? number.replace(/\.?0*$/, "") : number);
    if (exponent < -4 || exponent >= digits) {
      const power = String(Math.abs(exponent)).padStart(2, "0");
      return sign + strip(text[0] + "." + text.slice(1)) + "e" + (exponent < 0 ? "-" : "+") + power;
    }
    if (exponent < 0) return sign + strip("0." + "0".repeat(-exponent - 1) + text);
    return sign + strip(text.slice(0, exponent + 1) + "." + text.slice(exponent + 1));
  };

  function suitablePower(magnitude, power) {
    for (const [factor, symbol] of lengthPrefixes)
      if (magnitude >= factor ** power) return [factor ** power, symbol];
    return [1e-6 ** power, "u"];
  }

  function suitable(value, unit) {
    const magnitude = Math.abs(value);
    if (!(magnitude > 0) || !Number.isFinite(magnitude)) return [1, ""];
    if (unit === "m^2") return suitablePower(magnitude, 2);
    if (unit === "m^3") return suitablePower(magnitude, 3);
    for (const prefix of prefixes) {
      const isLength = unit === "m";
      if (isLength && prefix[0] > 1) continue;
      const least = isLength && prefix[0] === 1 ? 10 : 1;
      if (magnitude >= least * prefix[0]) return prefix;
    }
    return prefixes[prefixes.length - 1];
  }

  // "6.838 mm", "674.1 MPa".
  isopatch.withUnit = function (value, unit) {
    if (value === 0) return "0 " + unit;
    const [factor, symbol] = suitable(value, unit);
    return isopatch.general(value / factor, 4) + " " + symbol + unit;
  };

  // "(1.2, 0, -3.4) kN": the largest component chooses the prefix.
  isopatch.vectorWithUnit = function (vector, unit) {
    const largest = Math.max(...vector.map(Math.abs));
    const [factor, symbol] = suitable(largest, unit);
    const digits = (x) => isopatch.general(Math.abs(x) < 1e-7 * largest ? 0 : x / factor, 4);
    return "(" + vector.map(digits).join(", ") + ") " + symbol + unit;
  };

  // "(198.02, -179.69, -27.44) mm", digits to a hundred thousandth of the model's size.
  isopatch.placeWithUnit = function (place, modelSize) {
    const metres = modelSize >= 10;
    const factor = metres ? 1 : 1e-3;
    const step = 10 ** (Math.floor(Math.log10(Math.max(modelSize, 1e-12))) - 4);
    const digits = (x) => isopatch.general((Math.round(x / step) * step) / factor + 0.0, 6);
    return "(" + place.map(digits).join(", ") + ") " + (metres ? "m" : "mm");
  };

  isopatch.withoutRoundOff = (value, scale) => (Math.abs(value) < 1e-10 * scale ? 0 : value);
  isopatch.withSeparators = (count) => String(count).replace(/\B(?=(\d{3})+$)/g, ",");

  isopatch.bytesText = function (bytes) {
    if (bytes >= 1e9) return isopatch.general(bytes / 1e9, 3) + " GB";
    if (bytes >= 1e6) return isopatch.general(bytes / 1e6, 3) + " MB";
    return isopatch.general(bytes / 1e3, 3) + " kB";
  };

  isopatch.secondsText = function (seconds) {
    if (seconds < 100) return seconds.toFixed(2) + " s";
    return Math.trunc(seconds / 60) + " min " + (Math.trunc(seconds) % 60) + " s";
  };

  // Round numbers between low and high, at most count + 1 of them.
  isopatch.ticks = function (low, high, count) {
    if (!(high > low)) return [low];
    const raw = (high - low) / count;
    const power = 10 ** Math.floor(Math.log10(raw));
    const step = [1, 2, 5, 10].find((n) => n * power >= raw * (1 - 1e-9)) * power;
    const result = [];
    for (let i = Math.ceil(low / step - 1e-6); i <= high / step + 1e-6; ++i) result.push(i * step);
    return result;
  };
})(globalThis.isopatch);
