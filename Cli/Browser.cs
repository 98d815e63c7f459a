using System.ComponentModel;
using System.CommandLine;
using System.Diagnostics;
using Nowpose.Gateway.Options;

namespace Nowpose.Cli;

/// <summary>Opens a page in the browser of the user's desktop.</summary>
/// <param name="needsDisplay">Whether a desktop sets DISPLAY or WAYLAND_DISPLAY on this platform.</param>
/// <param name="environment">Gets the value of an environment variable.</param>
/// <param name="start">Starts a program and returns without waiting for it to exit.</param>
sealed class Browser(bool needsDisplay, Func<string, string> environment, Action<ProcessStartInfo> start)
{
    static readonly Browser OfThisMachine = new(
        !OperatingSystem.IsWindows() && !OperatingSystem.IsMacOS(), Environment.GetEnvironmentVariable, settings => Process.Start(settings)?.Dispose());

    /// <summary>Creates the option <c>--open</c>.</summary>
    public static Option<bool> Option() => SwitchOption.Create("--open", "Open the page in the browser of this desktop");

    /// <summary>Opens a page, or prints one line with the reason why the page cannot be opened.</summary>
    public static void OpenOrExplain(string path)
    {
        if (OfThisMachine.Open(path) is { } reason) Console.Error.WriteLine(ConsoleMessages.NotOpened(reason, path));
    }

    /// <returns>Null if the desktop accepted the request; otherwise the reason why the page cannot be opened.</returns>
    public string Open(string path)
    {
        if (needsDisplay && string.IsNullOrEmpty(environment("DISPLAY")) && string.IsNullOrEmpty(environment("WAYLAND_DISPLAY")))
            return ConsoleMessages.NoDesktop;
        try
        {
            // UseShellExecute selects the desktop's opener: the shell on Windows, open on macOS, xdg-open elsewhere.
            start(new ProcessStartInfo(path) { UseShellExecute = true });
            return null;
        }
        catch (Win32Exception e)
        {
            return ConsoleMessages.DesktopFailed(e.Message);
        }
    }
}
