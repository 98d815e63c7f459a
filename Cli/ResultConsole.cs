using Spectre.Console;

namespace Nowpose.Cli;

/// <summary>The console for tables: stdout; for a file or pipe without colours and with a fixed width.</summary>
static class ResultConsole
{
    const int RedirectedWidth = 120;

    public static IAnsiConsole Create()
    {
        var settings = new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Out) };
        if (!Console.IsOutputRedirected) return AnsiConsole.Create(settings);

        settings.Ansi = AnsiSupport.No;
        settings.ColorSystem = ColorSystemSupport.NoColors;
        var console = AnsiConsole.Create(settings);
        console.Profile.Width = RedirectedWidth;
        return console;
    }
}
