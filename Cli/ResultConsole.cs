using Spectre.Console;

namespace Nowpose.Cli;

/// <summary>Creates the console for tables on stdout. For a file or pipe, it has no colours and a fixed width.</summary>
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
