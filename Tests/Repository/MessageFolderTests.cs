using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

/// <summary>Checks that all texts that a product shows to users are in its message catalogue, the folder Messages of its sources.</summary>
public sealed partial class MessageFolderTests
{
    const int MaxWords = 3;
    const string Core = RepositoryFiles.Package + "/Runtime/Core/";
    const string Editor = RepositoryFiles.Package + "/Editor/";

    static readonly string[] Products = [RepositoryFiles.Package + "/Runtime/", Editor, "Gateway/", "Cli/", "Web/", "Vision/"];

    /// <summary>The folder of the metrics. Each metric is written next to its help, so the strings of the folder are not counted.</summary>
    const string Metrics = "Gateway/Status/Prometheus/";

    /// <summary>Calls whose arguments name and describe a command or an option.</summary>
    static readonly string[] Help =
    [
        "Command", "Invocation.Root", "BoxOption.Create", "ChoiceOption.Create", "NumberOption.Create", "NumberOption.CreateOptional",
        "NumberOption.CreateList", "RangeOption.Create", "RuntimeOptions.Profile", "SwitchOption.Create", "TextOption.Create", "TextOption.CreateList",
    ];

    /// <summary>Other files with longer texts that are not messages, and the number of these texts.</summary>
    static readonly Dictionary<string, int> Exceptions = new()
    {
        // The heads of HTTP requests and responses, and the operations of rosbridge.
        [Core + "Network/WebSocketUpgrade.cs"] = 1,
        [Core + "Pairing/PairingRequest.cs"] = 1,
        ["Gateway/SecurityHeaders.cs"] = 1,
        ["Gateway/Rosbridge/RequestText.cs"] = 1,
        // The XML for Unity's linker.
        [Editor + "LinkerProtection.cs"] = 1,
        // The help of options.
        ["Cli/Calibrate/DeviceOptions.cs"] = 6,
        // The head of pages in HTML.
        ["Web/PlainPage.cs"] = 1,
        // A catalogue that is too small for a folder of its own.
        ["Vision/PictureReaderMessages.cs"] = 3,
        // The name of a scene.
        ["Cli/Demo/DemoHeadset.cs"] = 1,
    };

    static IEnumerable<string> Sources => RepositoryFiles.All.Where(file => file.EndsWith(".cs", StringComparison.Ordinal)
        && Products.Any(product => file.StartsWith(product, StringComparison.Ordinal)) && !file.Contains("/Messages/", StringComparison.Ordinal));

    // Two tests check the same texts, and finding them takes seconds.
    static readonly Lazy<(string File, IReadOnlyList<SourceText> Texts)[]> Found =
        new(() => [.. Sources.Select(file => (file, SourceTexts.In(RepositoryFiles.Read(file))))]);

    [Test]
    public void Texts_OfProducts_AreInTheirCatalogue()
    {
        var found = Found.Value.Where(source => !source.File.StartsWith(Metrics, StringComparison.Ordinal)).Select(source => (source.File, Texts: LongTexts(source.Texts).ToList()))
            .Where(source => source.Texts.Count != Exceptions.GetValueOrDefault(source.File))
            .Select(source => $"{source.File}: {source.Texts.Count} strings:\n  {string.Join("\n  ", source.Texts)}");

        Assert.That(
            found, Is.Empty,
            $"move strings of more than {MaxWords} words to the folder Messages of the product. Help stays where it is: that of a command or an option as an "
            + $"argument of {string.Join(", ", Help)} or as a Description, that of a metric in {Metrics}");
    }

    [Test]
    public void TextsOfExceptionsAndLogs_OfProducts_AreInTheirCatalogue()
    {
        var found = Found.Value.SelectMany(source => ReportedTexts(source.Texts).Select(text => $"{source.File}: {text}"));

        Assert.That(string.Join("\n", found), Is.Empty, "move these texts of exceptions and log lines to the folder Messages of the product");
    }

    [Test]
    public void ListOfExceptions_Files_Exist() => Assert.That(Exceptions.Keys.Except(Sources), Is.Empty);

    [TestCase("throw new E(\"a file has no end\");", "a file has no end")]
    [TestCase("throw new E(\"no end\");", null)]
    [TestCase("var a = \"file \" + Name(x) + \" has \" + n + \" bytes too many\";", "file 0 has 0 bytes too many")]
    [TestCase("var a = x + \" has no end yet\";", "0 has no end yet")]
    [TestCase("var a = $\"file {Name(\"x\")} has {n:0.0} bytes too {{many}}\";", "file 0 has 0 bytes too {many}")]
    [TestCase("var a = isOn ? \"it is on\" : \"it is off\";", null)]
    [TestCase("Call(\"one two\", \"three four\");", null)]
    [TestCase("[Tooltip(\"the length of the arm\")] int _length;", null)]
    [TestCase("int _a; [SerializeField, Tooltip(\"the length of the arm\")] int _length;", null)]
    [TestCase("string[] a = [\"a list of four words\"];", "a list of four words")]
    [TestCase("// the length of \"the arm is one metre\"", null)]
    [TestCase("var c = '\"'; var a = \"the arm is long\";", "the arm is long")]
    [TestCase("var a = @\"the \"\"arm\"\" is long\";", "the \"arm\" is long")]
    [TestCase("new Command(\"demo\", \"shows how the product works\")", null)]
    [TestCase("new Option<int>(\"--x\") { Description = \"the length of the arm\", }", null)]
    [TestCase("Log($\"{(isOn ? \"the arm is on now\" : \"off\")}\");", "the arm is on now")]
    public void LongTexts_SampleSource_ReturnsOnlyItsLongTexts(string source, string expected) =>
        Assert.That(LongTexts(SourceTexts.In(source)), expected == null ? Is.Empty : Is.EqualTo(new[] { expected }));

    [TestCase("throw new InputException(path + \": no end\");", "0: no end")]
    [TestCase("throw new InputException($\"{path}: {(isOn ? \"on\" : \"off\")}\");", "on", "off")]
    [TestCase("throw new InputException(isOn ? \"on\" : (\"off\"));", "on", "off")]
    [TestCase("throw new InputException(Messages.Of(\"arm\"), fault);")]
    [TestCase("throw new InputException($\"{path}: {Messages.End}; {string.Join(\", \", names)}\");")]
    [TestCase("throw fields.Fault(\"no end\");", "no end")]
    [TestCase("ConsoleLog.Warn(this, \"lost\");", "lost")]
    [TestCase("Announcement.Log(\"lost\");", "lost")]
    [TestCase("_log(\"lost\");", "lost")]
    [TestCase("Console.Error.WriteLine(\"nowpose: \" + note);", "nowpose: 0")]
    [TestCase("Console.Out.WriteLine(\"code \" + code);")]
    public void ReportedTexts_SampleSource_ReturnsTextsOfExceptionsAndLogs(string source, params string[] expected) =>
        Assert.That(ReportedTexts(SourceTexts.In(source)), Is.EqualTo(expected));

    static IEnumerable<string> LongTexts(IEnumerable<SourceText> texts) => texts
        .Where(text => !Help.Contains(text.Call) && text.Assigned != "Description")
        .Select(text => text.Text).Where(text => SourceTexts.WordsIn(text) > MaxWords);

    /// <summary>Returns the texts that contain a word and are passed to an exception, to a method that creates one, or to a log.</summary>
    static IEnumerable<string> ReportedTexts(IEnumerable<SourceText> texts) => texts
        .Where(text => Reporter().IsMatch(text.Receiver) && SourceTexts.WordsIn(text.Text) > 0).Select(text => text.Text);

    [GeneratedRegex(@"(?:Exception|Error|Fault|Fail|Failed|Refuse|Refused|Warn|Info)$|\b_?[Ll]og\w*$|(?:\.Error|errors)\.Write\w*$")]
    private static partial Regex Reporter();
}
