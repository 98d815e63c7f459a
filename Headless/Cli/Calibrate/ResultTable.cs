using Nowpose.Cli.Calibrate.Page;
using Spectre.Console;

namespace Nowpose.Cli.Calibrate;

/// <summary>What a calibration found, on stdout.</summary>
static class ResultTable
{
    /// <param name="hasProfile">Whether there is one to name.</param>
    public static void Print(CalibrationPageData page, CalibrationOutput output, bool hasProfile = true)
    {
        var table = new Table().AddColumns("result", "");
        foreach (var fact in page.Facts) table.AddRow(Markup.Escape(fact[0]), Markup.Escape(fact[1]));
        ResultConsole.Create().Write(table);
        Console.Out.WriteLine(page.Result);
        Warn(page);
        if (hasProfile) Console.Out.WriteLine(output.ProfilePath);
        Console.Out.WriteLine(output.PagePath);
    }

    /// <summary>What is doubtful, on stderr: beside a table and beside JSON.</summary>
    public static void Warn(CalibrationPageData page)
    {
        foreach (var warning in page.Warnings) Console.Error.WriteLine("nowpose: " + warning);
    }
}
