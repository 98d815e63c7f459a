using NUnit.Framework;

namespace Nowpose.Headless.Tests.ControlSystem;

/// <summary>Runs the PLC's Structured Text unchanged and compares it with codes from another program.</summary>
public class LedMatrixTests
{
    const ulong NsPerMs = 1_000_000;
    const ulong PeriodNs = 65_536 * NsPerMs;

    static string Text(string file) => File.ReadAllText(CodeVectors.PathOf(file));

    static StructuredText Block() => new(Text("FB_NowposeLedCode.st"));

    static IEnumerable<CodeVectors.Row> Codes => CodeVectors.Read().Where(vector => vector.Kind == "control");

    static byte[] RowsOf(StructuredText block, ulong controlTimeNs)
    {
        block["nControlTimeNs"] = controlTimeNs;
        block.Run();
        return [.. block.Array("aRows").Select(row => (byte)row)];
    }

    [Test]
    public void Block_ReferenceTimes_LightsTheExpectedRows()
    {
        var block = Block();

        foreach (var code in Codes)
            Assert.That(RowsOf(block, (ulong)code.ValueMs * NsPerMs), Is.EqualTo(code.Rows), code.ValueMs + " ms");
    }

    [TestCase(0UL)]
    [TestCase(NsPerMs - 1)]
    public void Block_TimeLongAfterTheEpoch_ShowsItsMillisecond(ulong intoTheMillisecondNs)
    {
        var block = Block();
        const ulong epoch = 26_000 * PeriodNs;

        foreach (var code in Codes)
            Assert.That(RowsOf(block, epoch + (ulong)code.ValueMs * NsPerMs + intoTheMillisecondNs), Is.EqualTo(code.Rows), code.ValueMs + " ms");
    }

    // TwinCAT's default sends the outputs directly after the program; with "I/O at task start", the next cycle sends them.
    [TestCase(0)]
    [TestCase(1)]
    public void Program_EachCycle_ShowsTheTimeAtWhichItsOutputsTakeEffect(int cyclesLater)
    {
        var dcTime = 0UL;
        var delayed = Text("PRG_NowposeLedMatrix.st").Replace("nOutputDelayNs : ULINT := 0;", $"nOutputDelayNs : ULINT := {cyclesLater}000000;");
        var program = new StructuredText(
            delayed, new() { ["F_GetCurDcTaskTime64"] = () => dcTime }, type => type == "FB_NowposeLedCode" ? Block() : null);

        foreach (var code in Codes.Where(code => code.ValueMs > 0))
        {
            dcTime = 3 * PeriodNs + (ulong)(code.ValueMs - cyclesLater) * NsPerMs;
            program.Run();
            Assert.That(program.Array("aLeds").Select(row => (byte)row), Is.EqualTo(code.Rows), code.ValueMs + " ms");
        }
    }

    [TestCase("wValue XOR SHR(wValue, 1)", "wValue", TestName = "Block_WithoutGrayCode_IsDetected")]
    [TestCase("bOdd := NOT bOdd", "bEven := NOT bEven", TestName = "Block_WithOneParity_IsDetected")]
    [TestCase("MOD 65536", "MOD 32768", TestName = "Block_FewerBits_IsDetected")]
    [TestCase("aRows[0] := BYTE#16#9F", "aRows[0] := BYTE#16#F9", TestName = "Block_MarksOnTheWrongSide_IsDetected")]
    public void Block_FaultInItsSource_IsDetected(string right, string wrong)
    {
        var block = new StructuredText(Text("FB_NowposeLedCode.st").Replace(right, wrong));

        Assert.That(Codes.Any(code => !RowsOf(block, (ulong)code.ValueMs * NsPerMs).SequenceEqual(code.Rows)), Is.True);
    }

    [TestCase("WHILE TRUE DO END_WHILE")]
    [TestCase("wGray := ROL(wGray, 1);")]
    public void StructuredText_UnsupportedStatement_Throws(string statement)
    {
        var text = Text("FB_NowposeLedCode.st").Replace("END_FUNCTION_BLOCK", statement + "\nEND_FUNCTION_BLOCK");

        Assert.That(() => new StructuredText(text).Run(), Throws.InstanceOf<Exception>());
    }

    [TestCase("END_IF;", "END_IF")]
    [TestCase("END_FOR;", "END_FOR")]
    public void StructuredText_BlockWithoutSemicolon_IsRefusedAsTheStandardRequires(string ended, string open)
    {
        var text = Text("FB_NowposeLedCode.st").Replace(ended, open);
        var program = new StructuredText(text);

        var fault = Assert.Throws<FormatException>(program.Run);

        Assert.That(fault.Message, Does.Contain("';' expected").And.Contain(open));
    }
}
