using Spectre.Console;

namespace Nowpose.Cli.Calibrate;

/// <summary>Prints a calibration's result to stdout and its warnings to stderr.</summary>
static class CalibrationTable
{
    /// <param name="profilePath">Path of the profile; null if none was written.</param>
    /// <param name="json">JSON to print instead of the table; null prints the table.</param>
    public static void Print(CalibrationPageData page, string profilePath, string pagePath, string json)
    {
        if (json == null) PrintTable(page);
        foreach (var warning in page.Warnings) Console.Error.WriteLine(ConsoleMessages.Line(warning));
        if (json != null)
        {
            Console.Out.WriteLine(json);
            return;
        }
        if (profilePath != null) Console.Out.WriteLine(profilePath);
        Console.Out.WriteLine(pagePath);
    }

    static void PrintTable(CalibrationPageData page)
    {
        var table = new Table().AddColumns("result", "");
        foreach (var fact in page.Facts) table.AddRow(Markup.Escape(fact[0]), Markup.Escape(fact[1]));
        ResultConsole.Create().Write(table);
        Console.Out.WriteLine(page.Result);
    }
}
