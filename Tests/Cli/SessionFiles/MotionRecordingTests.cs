using System.Globalization;
using System.IO.Compression;
using System.Text;
using Nowpose.Cli.SessionFiles;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.MotionRecordings;
using Nowpose.Tests.Core;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.SessionFiles;

public class MotionRecordingTests
{
    TemporaryFolder _folder;

    [SetUp]
    public void CreateFolder() => _folder = new();

    [TearDown]
    public void DeleteFolder() => _folder.Dispose();

    string Write(string content, string name = "motion.csv") => Write(Encoding.UTF8.GetBytes(content), name);

    string Write(byte[] content, string name)
    {
        var path = Path.Combine(_folder.Path, name);
        File.WriteAllBytes(path, content);
        return path;
    }

    static byte[] Packed(string content)
    {
        var packed = new MemoryStream();
        using (var gzip = new GZipStream(packed, CompressionMode.Compress)) gzip.Write(Encoding.UTF8.GetBytes(content));
        return packed.ToArray();
    }

    static double[] At(MotionRecording recording, double seconds)
    {
        var positions = new double[recording.Names.Count];
        recording.At(seconds, positions);
        return positions;
    }

    const string TwoJoints = "t,a,b\n10,0,1\n10.5,1,1\n12,4,-2\n";

    [Test]
    public void Read_TwoJoints_HasNamesStartAndDuration()
    {
        var recording = MotionRecording.Read(Write(TwoJoints));

        Assert.That(recording.Names, Is.EqualTo(new[] { "a", "b" }));
        Assert.That(recording.Start, Is.EqualTo(10));
        Assert.That(recording.Duration, Is.EqualTo(2));
    }

    [TestCase(-1, 0, 1)]
    [TestCase(0, 0, 1)]
    [TestCase(0.25, 0.5, 1)]
    [TestCase(0.5, 1, 1)]
    [TestCase(1.25, 2.5, -0.5)]
    [TestCase(2, 4, -2)]
    [TestCase(99, 4, -2)]
    public void At_AnyTime_InterpolatesAndClamps(double seconds, double a, double b)
    {
        Assert.That(At(MotionRecording.Read(Write(TwoJoints)), seconds), Is.EqualTo(new[] { a, b }));
    }

    [TestCase("t,a,b\r\n10,0,1\r\n10.5,1,1\r\n12,4,-2\r\n", TestName = "Read_CrLf_ReturnsTheSameValues")]
    [TestCase("\uFEFFt,a,b\n10,0,1\n10.5,1,1\n12,4,-2", TestName = "Read_ByteOrderMark_ReturnsTheSameValues")]
    [TestCase("t_s,a,b\n10,0,1\n10.5,1,1\n12,4,-2\n\n\n  \n", TestName = "Read_TrailingBlankLines_ReturnsTheSameValues")]
    [TestCase("\"t\",\"a\",\"b\"\n 10, 0 ,1.0e0\n+10.5,1,1\n12,4,-2\n", TestName = "Read_QuotesAndSpaces_ReturnsTheSameValues")]
    public void Read_OtherNotation_ReturnsTheSameValues(string content)
    {
        var recording = MotionRecording.Read(Write(content));

        Assert.That(recording.Names, Is.EqualTo(new[] { "a", "b" }));
        Assert.That(recording.Duration, Is.EqualTo(2));
        Assert.That(At(recording, 1.25), Is.EqualTo(new[] { 2.5, -0.5 }));
    }

    [Test]
    public void Read_Gzip_ReturnsTheSameValues()
    {
        var recording = MotionRecording.Read(Write(Packed(TwoJoints), "motion.csv.gz"));

        Assert.That(At(recording, 1.25), Is.EqualTo(new[] { 2.5, -0.5 }));
    }

    [Test]
    public void Read_CultureWithDecimalComma_ReadsDecimalPoints()
    {
        using var culture = new DecimalComma();

        Assert.That(MotionRecording.Read(Write("t,a\n0.5,1.25\n1,2\n")).Start, Is.EqualTo(0.5));
    }

    [Test]
    public void At_UnixTimes_KeepsTheSampleSpacing()
    {
        var recording = MotionRecording.Read(Write("t,a\n1700000000.25,0\n1700000000.375,1\n1700000000.5,3\n"));

        Assert.That(recording.Duration, Is.EqualTo(0.25));
        Assert.That(At(recording, 0.1875)[0], Is.EqualTo(2));
    }

    [Test]
    public void At_UnixTimesAMillisecondApart_IsExact()
    {
        var rows = Enumerable.Range(0, 1000).Select(i => $"1700000010.{i:D3},{(i == 500 ? 1 : 0)}");
        var recording = MotionRecording.Read(Write("t,a\n" + string.Join("\n", rows)));

        Assert.That(recording.Start, Is.EqualTo(1.70000001e9));
        Assert.That(recording.Duration, Is.EqualTo(0.999).Within(1e-12));
        // The slope next to the row with value 1 is 1 per ms, so an error of 1e-12 s in time is an error of 1e-9 in the value.
        Assert.That(At(recording, 0.5)[0], Is.EqualTo(1).Within(1e-9));
        Assert.That(At(recording, 0.4995)[0], Is.EqualTo(0.5).Within(1e-9));
        Assert.That(At(recording, 0.5005)[0], Is.EqualTo(0.5).Within(1e-9));
    }

    [TestCase("0", "1e-40")]
    [TestCase("-1e40", "1e40")]
    [TestCase("1e-30", "1e300")]
    public void Read_TimesBeyondDecimal_AreReadAsDoubles(string first, string second)
    {
        var duration = double.Parse(second, CultureInfo.InvariantCulture) - double.Parse(first, CultureInfo.InvariantCulture);

        Assert.That(MotionRecording.Read(Write($"t,a\n{first},0\n{second},1\n")).Duration, Is.EqualTo(duration));
    }

    // As Excel saves "CSV (Comma delimited)" on Windows.
    [TestCase("motion.csv", "")]
    [TestCase("motion.csv", "\u00ef\u00bb\u00bf")]
    [TestCase("session.jsonl", "")]
    public void Read_TextInLatin1_NamesTheEncoding(string name, string mark)
    {
        var path = Write(Encoding.Latin1.GetBytes(mark + "t,Gr\u00f6\u00dfe\n0,1\n1,2\n"), name);

        Assert.That(
            () => name == "motion.csv" ? (object)MotionRecording.Read(path) : new SessionFileReader(path),
            Throws.TypeOf<InputException>().With.Message.EqualTo(MotionFileMessages.NotUtf8(path, 0xf6)));
    }

    [TestCase("utf-8")]
    [TestCase("utf-16")]
    public void Read_TextWithAByteOrderMark_IsRead(string encoding)
    {
        var chosen = Encoding.GetEncoding(encoding);
        var path = Write([.. chosen.Preamble, .. chosen.GetBytes("t,\u00f6\n0,1\n1,2\n")], "motion.csv");

        Assert.That(MotionRecording.Read(path).Names, Is.EqualTo(new[] { "\u00f6" }));
    }

    [Test]
    public void NotANumber_TextWithAComma_NamesTheDecimalSeparator()
    {
        Assert.That(MotionFileMessages.NotANumber("'a'", "'1,5'"), Does.EndWith(MotionFileMessages.NumberRemedy(hasComma: true)));
        Assert.That(MotionFileMessages.NotANumber("'a'", "'left'"), Does.EndWith(MotionFileMessages.NumberRemedy(hasComma: false)));
    }

    static readonly string[][] InvalidContents =
    [
        ["", MotionFileMessages.Empty("")],
        ["\n\n", MotionFileMessages.Empty("")],
        ["0,1\n1,2\n", ":1: " + MotionFileMessages.FirstColumn("'0'")],
        ["time,a\n0,1\n1,2\n", ":1: " + MotionFileMessages.FirstColumn("'time'")],
        ["t;a\n0,0;1,5\n0,1;2,5\n", ":1: " + MotionFileMessages.OtherSeparator("semicolons")],
        ["\"t_s\";\"a\"\n0,0;1,5\n0,1;2,5\n", ":1: " + MotionFileMessages.OtherSeparator("semicolons")],
        ["t\ta\n0\t1\n1\t2\n", ":1: " + MotionFileMessages.OtherSeparator("tabs")],
        ["t,a\n0,\"1,5\"\n1,2\n", ":2: " + MotionFileMessages.NotANumber("'a'", "'1,5'")],
        ["t\n0\n1\n", ":1: " + MotionFileMessages.NoJoint("t")],
        ["t,a,\n0,1,2\n1,2,3\n", ":1: " + MotionFileMessages.NoName(3)],
        ["t,a,b,a\n0,1,2,3\n1,2,3,4\n", ":1: " + MotionFileMessages.NameTwice(4, "'a'")],
        ["t,a,t\n0,1,2\n1,2,3\n", ":1: " + MotionFileMessages.NameTwice(3, "'t'")],
        ["t,a\n0,1\n1,\n", ":3: " + MotionFileMessages.EmptyField("'a'")],
        ["t,a\n0,1\n,2\n", ":3: " + MotionFileMessages.EmptyField("'t'")],
        ["t,a\n0,1\n1,left\n2,3\n", ":3: " + MotionFileMessages.NotANumber("'a'", "'left'")],
        ["t,a\n0,1\n1,0x10\n2,3\n", ":3: " + MotionFileMessages.NotANumber("'a'", "'0x10'")],
        ["t,a\n0,NaN\n1,1\n", ":2: " + MotionFileMessages.NotFinite("'a'", "'NaN'")],
        ["t,a\n0,1\n1,1e999\n", ":3: " + MotionFileMessages.NotFinite("'a'", "'1e999'")],
        ["t,a\n0,1\n1,-inf\n", ":3: " + MotionFileMessages.NotFinite("'a'", "'-inf'")],
        ["t,a\n0,1\n-Infinity,1\n", ":3: " + MotionFileMessages.NotFinite("'t'", "'-Infinity'")],
        ["t,a\n0,1\n2,2\n1,3\n", ":4: " + MotionFileMessages.TimeOrder("t", "'1'")],
        ["t_s,a\n0,1\n1,2\n\n1,3\n", ":5: " + MotionFileMessages.TimeOrder("t_s", "'1'")],
        ["t,a\n0,1\n1,2,3\n", ":3: " + MotionFileMessages.FieldCount(3, 2)],
        ["t,a,b\n0,1,2\n1,2\n", ":3: " + MotionFileMessages.FieldCount(2, 3)],
        ["t,a\n0,1\n", MotionFileMessages.TooFewRows("", 1)],
        ["t,a\n", MotionFileMessages.TooFewRows("", 0)],
        ["t,a\n0,1\n1,2\"3\n", MotionFileMessages.Quotation("", 3)],
        ["t,a\n0,1\n1,\"2\n3,4\n", MotionFileMessages.Quotation("", 3)],
    ];

    [TestCaseSource(nameof(InvalidContents))]
    public void Read_InvalidContent_ThrowsWithAOneLineMessageNamingThePlace(string content, string expected) =>
        AssertRefused(Write(content), expected);

    [Test]
    public void Read_MissingFile_NamesTheFile() => AssertRefused(Path.Combine(_folder.Path, "none.csv"), PathMessages.NotFound(""));

    [Test]
    public void Read_MissingFolder_NamesTheFile() => AssertRefused(Path.Combine(_folder.Path, "none", "none.csv"), PathMessages.NotFound(""));

    [Test]
    public void Read_PathIsAFolder_NamesThePath() => AssertRefused(_folder.Path, MotionFileMessages.IsAFolder(""));

    [Test]
    public void Read_NotGzip_NamesTheFile() => AssertRefused(Write(TwoJoints, "motion.csv.gz"), MotionFileMessages.NotGzip(""));

    [Test]
    public void Read_TruncatedGzip_IsRefused()
    {
        var noise = new Random(1);
        var rows = string.Concat(Enumerable.Range(0, 2000).Select(i => FormattableString.Invariant($"{i},{noise.NextDouble()}\n")));
        var packed = Packed("t,a\n" + rows);

        AssertRefused(Write(packed[..(packed.Length / 2)], "motion.csv.gz"), MotionFileMessages.NotGzip(""));
    }

    static void AssertRefused(string path, string expected)
    {
        var e = Assert.Throws<InputException>(() => MotionRecording.Read(path));

        Assert.That(e.Message, Is.EqualTo(path + expected));
    }
}
