#include <exception>
#include <new>
#include <system_error>

#include "app/commands.h"
#include "app/messages.h"
#include "app/options.h"
#include "app/signals.h"
#include "scene/error.h"

using namespace restframe;

// Exit codes: 0 done; 1 a defect of ours; 2 bad input or options; 3 output or resources failed;
// 130 interrupted.
int main(int argc, char** argv) {
  try {
    require_processor();
    catch_signals();
    const Options options = parse_options(argc, argv);
    const int exit_code = run(options);
    close_standard_output();
    return exit_code;
  } catch (const HelpShown& shown) {
    return shown.exit_code;
  } catch (const InputError& error) {
    report_faults(error.faults());
    return 2;
  } catch (const OutputError& error) {
    report_error(error.what());
    return 3;
  } catch (const Interrupted&) {
    return report_interruption();
  } catch (const std::bad_alloc&) {
    report_error("out of memory; `restframe info` tells what a scene needs");
    return 3;
  } catch (const std::system_error& error) {  // of the system: no thread to be had, a closed output
    report_error(error.what());
    return 3;
  } catch (const std::exception& error) {
    report_error(std::string("a defect of restframe, please report it: ") + error.what());
    return 1;
  }
}
