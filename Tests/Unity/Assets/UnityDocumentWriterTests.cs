using Nowpose.UnityPlayer.Assets.Yaml;
using NUnit.Framework;
using YamlDotNet.RepresentationModel;

namespace Nowpose.Unity.Tests.Assets;

public sealed class UnityDocumentWriterTests
{
    const string Header = "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!114 &5\nMonoBehaviour:\n";

    [Test]
    public void Write_NestedValues_HaveUnitysLayout()
    {
        var fields = Nodes.Lines(
            ("m_Name", Nodes.Text("")),
            ("m_Position", Nodes.Braces(("x", Nodes.Number(1)), ("y", Nodes.Number(-2)))),
            ("m_Empty", Nodes.List()),
            ("_fingers", new YamlSequenceNode(Nodes.Lines(("joint", Nodes.Text("left")), ("finger", new AssetReference(7).Write())))),
            ("_materials", new YamlSequenceNode(new AssetReference(2100000, new string('a', 32), 2).Write())),
            ("_inner", Nodes.Lines(("deep", Nodes.Lines(("deeper", Nodes.Number(1)))))));

        Assert.That(Write(fields), Is.EqualTo(Header + """
              m_Name: 
              m_Position: {x: 1, y: -2}
              m_Empty: []
              _fingers:
              - joint: left
                finger: {fileID: 7}
              _materials:
              - {fileID: 2100000, guid: aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa, type: 2}
              _inner:
                deep:
                  deeper: 1

            """));
    }

    [TestCase("plain words", "plain words")]
    [TestCase("package://a/b.dae", "package://a/b.dae")]
    [TestCase("-", "'-'")]
    [TestCase("- a", "'- a'")]
    [TestCase("a: b", "'a: b'")]
    [TestCase("a:", "'a:'")]
    [TestCase("a #b", "'a #b'")]
    [TestCase("it's", "'it''s'")]
    [TestCase(" a", "' a'")]
    [TestCase("a ", "'a '")]
    [TestCase("<OnClicked>k__BackingField", "<OnClicked>k__BackingField")]
    [TestCase("<OnClicked>k__BackingField.m_Calls.Array.data[0].m_Mode", "<OnClicked>k__BackingField.m_Calls.Array.data[0].m_Mode")]
    [TestCase("<b>k", "'<b>k'")]
    [TestCase("{0}", "'{0}'")]
    [TestCase("[x]", "'[x]'")]
    [TestCase("a\nb\t\"c\"\\", "\"a\\nb\\t\\\"c\\\"\\\\\"")]
    [TestCase("–", "\"\\u2013\"")]
    public void Write_Text_IsQuotedIfNecessary(string text, string expected)
    {
        Assert.That(Write(Nodes.Lines(("a", Nodes.Text(text)))), Is.EqualTo(Header + "  a: " + expected + "\n"));
    }

    [Test]
    public void Write_LongText_WrapsAtASpaceAfterColumn80()
    {
        var text = new string('a', 80) + " " + new string('b', 90) + " c  d";

        Assert.That(Write(Nodes.Lines(("a", Nodes.Text(text)))),
            Is.EqualTo(Header + "  a: " + new string('a', 80) + "\n    " + new string('b', 90) + "\n    c  d\n"));
    }

    static readonly string[] Texts =
    {
        "", " ", "a", "~", "null", "true", "1e5", "-", "--- x", "? a", "!x", "&a", "*a", "%a", "@a", "`a`", "a, b", "a: b: c", "x #y", "'", "\"",
        "\\", "\\n", "a\r\nb", "\n", "\n\n  a\n   \n", "\ta", "é – ✓ 😀", "\u0001", new string('x', 200),
        string.Join(' ', Enumerable.Repeat("word", 60)), string.Join("  ", Enumerable.Repeat("two: blanks", 40)),
        string.Join("\n    ", Enumerable.Repeat("<link name=\"it's\"/>", 30)), string.Join(' ', Enumerable.Repeat("it's", 50)),
    };

    [TestCaseSource(nameof(Texts))]
    public void Write_AnyText_RoundTrips(string text)
    {
        var written = Write(Nodes.Lines(("a", Nodes.Text(text)), ("list", new YamlSequenceNode(Nodes.Text(text), Nodes.Text("end")))));

        var fields = UnityDocumentReader.Read(written, "x").Single().Fields;
        Assert.That(((YamlScalarNode)Nodes.Find(fields, "a")).Value, Is.EqualTo(text));
        Assert.That(((YamlScalarNode)((YamlSequenceNode)Nodes.Find(fields, "list"))[0]).Value, Is.EqualTo(text));
    }

    [Test]
    public void Write_FloatsOfAllSizes_RoundTrip()
    {
        var random = new Random(20240117);
        for (var i = 0; i < 20000; i++)
        {
            var value = BitConverter.Int32BitsToSingle(random.Next(int.MinValue, int.MaxValue));
            if (!float.IsFinite(value)) continue;

            Assert.That(Numbers.TryRead(Numbers.Write(value), out float back), Is.True, "seed 20240117, value {0:R}", value);
            Assert.That(BitConverter.SingleToInt32Bits(back), Is.EqualTo(BitConverter.SingleToInt32Bits(value)));
        }
    }

    [TestCase(0f, "0")]
    [TestCase(1f, "1")]
    [TestCase(-0.1f, "-0.1")]
    [TestCase(1e-7f, "1e-7")]
    [TestCase(1e20f, "1e20")]
    [TestCase(0.70710677f, "0.70710677")]
    public void NumbersWrite_Float_ReturnsTheShortestText(float value, string expected)
    {
        Assert.That(Numbers.Write(value), Is.EqualTo(expected));
    }

    static string Write(YamlMappingNode fields) => UnityDocumentWriter.Write(new[] { new UnityDocument(114, "MonoBehaviour", 5, fields) });
}
