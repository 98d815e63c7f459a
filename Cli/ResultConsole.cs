using Spectre.Console;

namespace Nowpose.Cli;

/// <summary>Where tables go: stdout, without colours and at a width of its own when it is a file or a pipe.</summary>
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
