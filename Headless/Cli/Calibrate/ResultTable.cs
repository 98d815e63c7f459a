using Nowpose.Cli.Calibrate.Page;
using Spectre.Console;

namespace Nowpose.Cli.Calibrate;

/// <summary>What a calibration found, on stdout.</summary>
static class ResultTable
{
    /// <param name="profilePath">Null for none.</param>
    public static void Print(CalibrationPageData page, string profilePath, string pagePath)
    {
        var table = new Table().AddColumns("result", "");
        foreach (var fact in page.Facts) table.AddRow(Markup.Escape(fact[0]), Markup.Escape(fact[1]));
        ResultConsole.Create().Write(table);
        Console.Out.WriteLine(page.Result);
        Warn(page);
        if (profilePath != null) Console.Out.WriteLine(profilePath);
        Console.Out.WriteLine(pagePath);
    }

    /// <summary>What is doubtful, on stderr: beside a table and beside JSON.</summary>
    public static void Warn(CalibrationPageData page)
    {
        foreach (var warning in page.Warnings) Console.Error.WriteLine("nowpose: " + warning);
    }
}
