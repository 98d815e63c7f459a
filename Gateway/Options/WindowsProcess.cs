using System.Runtime.InteropServices;

namespace Nowpose.Gateway.Options;

/// <summary>Adapts the process to Windows, whose timers and signals differ from those of other systems.</summary>
public static class WindowsProcess
{
    const uint TimerStepMs = 1;
    const int PowerThrottling = 4;
    const uint PowerThrottlingVersion = 1, IgnoreTimerResolution = 4;

    /// <summary>
    /// Gives the timers and sleeps of this process a step of 1 ms instead of 15.6 ms. Call this method once, at the
    /// start of the program. Does nothing on other systems.
    /// </summary>
    public static void SetUp()
    {
        if (!OperatingSystem.IsWindows()) return;
        SetTimerStep();
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

    // PROCESS_POWER_THROTTLING_STATE.
    [StructLayout(LayoutKind.Sequential)]
    struct ThrottlingState
    {
        public uint Version;
        public uint Changed;
        public uint Enabled;
    }
}
