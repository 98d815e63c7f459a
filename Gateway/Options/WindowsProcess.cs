using System.Runtime.InteropServices;
using System.Text;

namespace Nowpose.Gateway.Options;

/// <summary>Adapts the process to Windows, whose timers, console and signals differ from those of other systems.</summary>
public static class WindowsProcess
{
    const uint TimerStepMs = 1;
    const int PowerThrottling = 4;
    const uint PowerThrottlingVersion = 1, IgnoreTimerResolution = 4;
    const int StandardOutput = -11;
    const uint EscapeSequences = 4;

    /// <summary>
    /// Gives the timers and sleeps of this process a step of 1 ms instead of 15.6 ms, and its console all characters. Call this method once, at the
    /// start of the program, before the console is used. Does nothing on other systems.
    /// </summary>
    public static void SetUp()
    {
        if (!OperatingSystem.IsWindows()) return;
        SetTimerStep();
        // Writes with the console's Unicode function, which leaves the code page of the console unchanged for other programs. A file or a pipe keeps
        // the code page that its reader expects.
        if (!Console.IsOutputRedirected && !Console.IsErrorRedirected) Console.OutputEncoding = Encoding.Unicode;
    }

    /// <summary>Whether the console shows escape sequences. The console of Windows does after a call of this method, from Windows 10 on.</summary>
    public static bool ShowsEscapeSequences()
    {
        if (!OperatingSystem.IsWindows()) return true;
        var console = GetStandardHandle(StandardOutput);
        return GetConsoleMode(console, out var mode) && SetConsoleMode(console, mode | EscapeSequences);
    }

    /// <summary>Whether the system ends the process as soon as the handler of a signal returns.</summary>
    public static bool EndsAfter(PosixSignal signal) => OperatingSystem.IsWindows() && signal is PosixSignal.SIGHUP or PosixSignal.SIGTERM;

    static void SetTimerStep()
    {
        try
        {
            _ = SetTimerStep(TimerStepMs);
            // Windows 11 otherwise ignores the step while the window of the console is minimised. Older versions refuse this setting.
            var state = new ThrottlingState { Version = PowerThrottlingVersion, Changed = IgnoreTimerResolution, Enabled = 0 };
            _ = SetProcessInformation(GetCurrentProcess(), PowerThrottling, ref state, Marshal.SizeOf<ThrottlingState>());
        }
        catch (Exception e) when (e is DllNotFoundException or EntryPointNotFoundException)
        {
            // The smallest editions of Windows lack these functions. Waits then have the step of 15.6 ms.
        }
    }

    [DllImport("winmm", EntryPoint = "timeBeginPeriod")]
    static extern uint SetTimerStep(uint milliseconds);

    [DllImport("kernel32")]
    static extern nint GetCurrentProcess();

    [DllImport("kernel32")]
    static extern bool SetProcessInformation(nint process, int kind, ref ThrottlingState state, int bytes);

    [DllImport("kernel32", EntryPoint = "GetStdHandle")]
    static extern nint GetStandardHandle(int number);

    [DllImport("kernel32")]
    static extern bool GetConsoleMode(nint console, out uint mode);

    [DllImport("kernel32")]
    static extern bool SetConsoleMode(nint console, uint mode);

    // PROCESS_POWER_THROTTLING_STATE.
    [StructLayout(LayoutKind.Sequential)]
    struct ThrottlingState
    {
        public uint Version;
        public uint Changed;
        public uint Enabled;
    }
}
