#include "app/pages/internal/web_files.hpp"

// The assembler puts the files into the program as they are; the build makes page.js and page.css anew, and
// this file with them, when anything in web/ changes. NOLINTBEGIN(cppcoreguidelines-macro-usage): names of
// symbols and files are pasted into assembler text.
#define ISOPATCH_EMBED(name, file)                                                   \
  asm(".section .rodata\n.balign 16\n" #name "_begin:\n.incbin \"" file "\"\n" #name \
      "_end:\n.byte 0\n.previous\n");                                                \
  extern "C" const char name##_begin[];                                              \
  extern "C" const char name##_end[];
// NOLINTEND(cppcoreguidelines-macro-usage)

ISOPATCH_EMBED(isopatch_web_page, ISOPATCH_WEB_FOLDER "/page.html")
ISOPATCH_EMBED(isopatch_web_style, ISOPATCH_WEB_FOLDER "/page.css")
ISOPATCH_EMBED(isopatch_web_scripts, ISOPATCH_WEB_FOLDER "/page.js")

namespace isopatch::app {

std::string_view web_page() {
  return {isopatch_web_page_begin, isopatch_web_page_end};
}

std::string_view web_style() {
  return {isopatch_web_style_begin, isopatch_web_style_end};
}

std::string_view web_scripts() {
  return {isopatch_web_scripts_begin, isopatch_web_scripts_end};
}

}  // namespace isopatch::app
