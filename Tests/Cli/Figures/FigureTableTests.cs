using Nowpose.Cli.Figures.Model;
using Nowpose.Cli.Messages;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Figures;

public class FigureTableTests
{
    [TestCase("sampling interval", "ms", "sampling_interval_ms")]
    [TestCase("quadratic-h3 RMS", "mm", "quadratic_h3_RMS_mm")]
    [TestCase("speed", "mm/s", "speed_mm_per_s")]
    [TestCase("offset error", "µs", "offset_error_us")]
    [TestCase("ratio", "", "ratio")]
    public void Header_NameAndUnit_FormOneWord(string name, string unit, string header)
    {
        Assert.That(new FigureColumn(name, unit).Header, Is.EqualTo(header));
    }

    [Test]
    public void WriteCsv_Rows_UsesDecimalPointsAndEmptyFields()
    {
        var table = new FigureTable(new FigureColumn("time", "ms"), new FigureColumn("hold", "mm"));
        table.Add(0.5, -1234.5678912);
        table.Add(1, null);
        using var csv = new StringWriter();

        table.WriteCsv(csv);

        Assert.That(csv.ToString(), Is.EqualTo("time_ms,hold_mm\n0.5,-1234.567891\n1,\n"));
    }

    [TestCase(double.NaN)]
    [TestCase(double.PositiveInfinity)]
    public void Add_NotFinite_NamesColumnAndRow(double value)
    {
        var table = new FigureTable(new FigureColumn("time", "ms"), new FigureColumn("hold", "mm"));

        Assert.That(() => table.Add(1, value), Throws.ArgumentException.With.Message.Contains("hold_mm, row 1"));
    }

    [Test]
    public void Add_WrongNumberOfValues_Throws()
    {
        Assert.That(() => new FigureTable(new FigureColumn("time", "ms")).Add(1, 2),
            Throws.ArgumentException.With.Message.StartsWith(FigureErrors.ValueCount(2, 1)));
    }
}
