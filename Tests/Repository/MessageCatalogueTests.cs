using System.Net;
using System.Reflection;
using System.Text.RegularExpressions;
using Nowpose.Gateway.Messages;
using Nowpose.Protocol;
using Nowpose.Tests.Core;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

/// <summary>Tests that each text of the message catalogues is complete: it has no gaps and contains all its values.</summary>
public sealed partial class MessageCatalogueTests
{
    static readonly string[] Assemblies = ["Nowpose", "Nowpose.Unity", "Nowpose.Editor", "Nowpose.Gateway", "Nowpose.Cli", "Nowpose.Web", "Nowpose.Vision"];

    /// <summary>Values for the parameters of messages, by type. The value of a string is the parameter's name in angle brackets.</summary>
    static readonly Dictionary<Type, Func<string, object>> Samples = new()
    {
        [typeof(string)] = name => $"<{name}>",
        [typeof(int)] = _ => 7,
        [typeof(uint)] = _ => 7u,
        [typeof(long)] = _ => 7L,
        [typeof(long?)] = _ => 7L,
        [typeof(int?)] = _ => 7,
        [typeof(ulong)] = _ => 7ul,
        [typeof(double)] = _ => 7.5,
        [typeof(double?)] = _ => 7.5,
        [typeof(char)] = _ => '7',
        [typeof(IPAddress)] = _ => IPAddress.Parse("7.7.7.7"),
        [typeof(Uri)] = _ => new Uri("http://host7/"),
        [typeof(Version)] = _ => new Version(7, 7),
        [typeof(TimeSpan)] = _ => TimeSpan.FromSeconds(7),
        [typeof(DateTime)] = _ => new DateTime(2027, 7, 7),
        [typeof(Exception)] = _ => new IOException("<7>"),
        [typeof(IReadOnlyList<string>)] = name => new[] { $"<{name}>", "<7>" },
        [typeof(IReadOnlyCollection<string>)] = name => new[] { $"<{name}>", "<7>" },
    };

    /// <summary>Verbs of remedies.</summary>
    const string Verbs =
        "add|ask|assign|bind|build|calibrate|change|check|chmod|choose|clear|close|connect|continue|convert|copy|"
        + "correct|cover|create|delete|disable|enable|enter|evaluate|expand|export|extend|film|free|give|go|increase|"
        + "install|jog|keep|load|lock|log|look|make|mark|measure|move|name|open|pair|pass|place|print|publish|put|quote|"
        + "raise|read|record|reduce|release|remove|rename|renew|repeat|replace|report|request|reset|restart|restore|revoke|run|"
        + "save|scale|see|select|send|set|shorten|show|simplify|stand|start|state|stop|swap|sweep|switch|tag|take|tick|"
        + "try|turn|update|use|wait|write";

    /// <summary>Catalogues of states, results and log lines, which need no remedy.</summary>
    static readonly string[] OfStatuses =
        ["BaseStatusMessages", "ConsoleMessages", "PlannedPathMessages", "PlantClockMessages", "PoseMessages", "StampMessages", "StatusMessages"];

    /// <summary>
    /// Texts of the other catalogues that need no remedy: statuses, results, names, and parts of a message that contains the remedy elsewhere.
    /// </summary>
    static readonly Dictionary<string, string[]> OtherStatuses = new()
    {
        ["AccessMessages"] = ["BlockedLog", "ClosedForNewer", "FormerContentUsed", "OtherLinesUsed", "Refused", "TooManyWrongLog"],
        ["AdapterMessages"] = ["Ended"],
        ["AppearanceMessages"] = ["NoMaterial", "NotFadeable"],
        ["BaseMessages"] =
        [
            "BeingPlacedLabel", "FollowsMarker", "Lost", "LostLabel", "MovedLabel", "NotConfirmedLabel", "NotLocated", "NotLockedLabel",
        ],
        ["CellMessageFaults"] = ["Frame", "Has", "Named", "NoName", "Of", "StampZero", "Twice"],
        ["ComponentMessages"] = ["GripperWithoutJoint", "Of"],
        ["ConditionMessages"] = ["PlaceOfOpenXr", "PlaceOfQuality", "PlaceOfReprojection"],
        ["ConnectionMessages"] = ["Reported"],
        ["DeviceMessages"] =
        [
            "CountersPaired", "DepthAgain", "DepthSubmitted", "MarkerMode", "NoDisplayTime", "NotStoredYet", "PlanarLog", "PlanarProblem",
            "StoreFailed",
        ],
        // The name of the reason if nothing was dropped. A separate test checks all reasons.
        ["DropMessages"] = ["AsWritten", "Of"],
        ["DryRunMessages"] = ["MissingJoints", "MissingJointsLog", "PortInUse", "WarningLog"],
        ["FigureErrors"] = ["NotAValue", "NotFinite"],
        ["FrameMessages"] =
        [
            "FileLine", "FiniteNumber", "FrameNotCurrent", "FrameUnknown", "List", "MayBeGripped", "NoPose", "NotCurrent", "Object", "OfFrame",
            "OfTransform", "PosesStopped", "PosesTooRare", "Text",
        ],
        ["HeadsetMessages"] =
        [
            "AtEnd", "BaseNotCurrent", "CurrentAgain", "NeverCurrent", "NoJointsOfRobot", "OtherNamespaces", "Pose", "RecordingStopped",
        ],
        ["KeyFileMessages"] = ["Renewed"],
        ["KinematicsMessages"] = ["FixedJoint", "Title", "UnknownJoint"],
        ["LatencyProfileMessages"] = ["Of"],
        ["LimitMessages"] = ["MoreLines"],
        ["LoadSweepMessages"] = ["Building", "WaitingForClock"],
        ["LoaderMessages"] = ["Unkept"],
        ["ManifestMessages"] = ["TooDeep", "Twice"],
        ["MeshMessages"] = ["Of"],
        ["Mrtk3Messages"] = ["VisuByRuntime"],
        ["ObjectMessages"] = ["FingerNotMoved", "FromGripper", "MovedTwice", "OutsideStroke", "PlacedByHand", "RobotUnknown", "SignalNotCurrent"],
        ["OperationsMessages"] = ["LoggedIn", "NoTokenNeeded", "UnknownTokenLog"],
        ["OptionMessages"] = ["SeeHelp"],
        ["PairedCellMessages"] = ["Field", "List", "Unusable"],
        ["PairingAnswerMessages"] = ["Failed"],
        ["PairingCodeMessages"] = ["OtherBegin"],
        ["PairingMessages"] = ["Exchanging", "Known", "MarkerFirst", "Paired"],
        ["PairingServiceMessages"] = ["CodeRenewed", "NotStoredLog", "To", "TokenGiven", "WrongCodeLog"],
        ["ProfileMessages"] = ["OtherKind"],
        ["RecorderMessages"] = ["Begun", "Deleted", "Disabled", "Download", "Enabled", "Ended", "FolderNotChecked", "UnknownName"],
        ["RecordingMessages"] = ["Stopped"],
        ["RequestMessages"] = ["Closed", "Dropped", "NotAccepted"],
        ["RobotMessages"] = ["OfRobot", "Short"],
        ["SessionMessages"] =
        [
            "Description", "DescriptionUnusable", "FirstPositions", "NoRefreshesMissed", "PlausibleAgain", "Recording", "Stale", "Synchronised",
            "WithinRange",
        ],
        ["SessionFileMessages"] = ["AtByte"],
        ["SignalMessages"] = ["ClockUnsynchronised", "NoConnection", "NoValue", "NotCurrent", "OlderThanConnection", "StampMismatch"],
        ["SimulationMessages"] = ["Error", "Read", "Written"],
        ["SweepMessages"] = ["Responds"],
        ["SyncServerMessages"] = ["Closed", "ClosedFor", "NotAccepted"],
        ["UnityProjectMessages"] = ["Backup", "EntryKept", "Version"],
        ["UnityVersionMessages"] = ["Compared2022", "NotComparedNewest"],
        ["UrdfMessages"] = ["NotWellFormed"],
        ["VlcMessages"] = ["NothingRead", "OtherSource", "Result"],
    };

    static IEnumerable<Type> Catalogues => Assemblies.Select(Assembly.Load).SelectMany(assembly => assembly.GetTypes())
        .Where(type => type.Namespace is { } name && (name.EndsWith(".Messages", StringComparison.Ordinal) || (name == "Nowpose.Vision" && IsOfErrors(type))))
        .Where(type => type is { IsAbstract: true, IsSealed: true, IsNested: false });

    [Test]
    public void Texts_WithSampleValues_AreComplete()
    {
        var texts = Catalogues.SelectMany(TextsOf).ToList();
        Assert.That(texts, Has.Count.GreaterThan(1000), "the catalogues are found");

        Assert.That(texts.Where(text => Gap().IsMatch(text.Text)).Select(text => $"{text.Name}: {text.Text}"), Is.Empty);
    }

    [Test]
    public void Methods_WithSampleValues_StateEachNamedValue()
    {
        var missing = from method in Catalogues.SelectMany(MethodsOf)
                      let text = Call(method, true) + Call(method, false)
                      from parameter in method.GetParameters()
                      where parameter.ParameterType == typeof(string) && !text.Contains($"<{parameter.Name}>", StringComparison.Ordinal)
                      select $"{method.DeclaringType.Name}.{method.Name}: {parameter.Name}";

        Assert.That(missing, Is.Empty);
    }

    // The programs use the invariant culture; the package uses the culture of the device.
    [TestCase("Nowpose")]
    [TestCase("Nowpose.Unity")]
    [TestCase("Nowpose.Editor")]
    public void Texts_DecimalSeparatorIsAComma_AreTheSame(string assembly)
    {
        var catalogues = Catalogues.Where(type => type.Assembly.GetName().Name == assembly).ToList();
        var expected = catalogues.SelectMany(TextsOf).ToList();
        using var culture = new DecimalComma();

        Assert.That(catalogues.SelectMany(TextsOf).Except(expected).Select(text => $"{text.Name}: {text.Text}"), Is.Empty);
    }

    [Test]
    public void Errors_WithSampleValues_StateRemedyOrAllowedValues()
    {
        var incomplete = Incomplete();
        var statuses = OtherStatuses.SelectMany(catalogue => catalogue.Value.Select(text => $"{catalogue.Key}.{text}")).ToList();
        var missing = string.Join("\n", incomplete.Except(statuses));
        Assert.That(missing, Is.Empty, "complete these messages, or list those that are statuses or a part of a message");
        Assert.That(statuses.Except(incomplete), Is.Empty, "remove these from the list: they are complete or do not exist");
    }

    // The reasons for a name that belongs to another source are followed by the name of the source.
    [Test]
    public void DropMessages_EachReasonOfTheGateway_StateRemedyOrAllowedValues()
    {
        var texts = Enum.GetValues<DropReason>().Select(DropMessages.Of).Where(text => text.Contains(' ', StringComparison.Ordinal));

        Assert.That(texts.Where(text => !IsComplete(text)).Distinct(), Is.EqualTo(new[] { "belongs to another source" }));
    }

    [Test]
    public void DropMessages_NameTooLong_StatesTheLimitsOfNamesAndKeys()
    {
        var text = DropMessages.Of(DropReason.NameTooLong);

        Assert.That(text, Does.Contain($" {ProtocolLimits.NameLength} ").And.Contain($"({ProtocolLimits.KeyLength} "));
    }

    [TestCase("visu_ms is -3 ms", false)]
    [TestCase("visu_ms is -3 ms; calibrate again", true)]
    [TestCase("visu_ms is -3 ms; it must be between 0 and 1000 ms", true)]
    [TestCase("the open file is in use", false)]
    [TestCase("the address is unknown", false)]
    public void IsComplete_Sample_RequiresRemedyOrAllowedValues(string text, bool expected) => Assert.That(IsComplete(text), Is.EqualTo(expected));

    static List<string> Incomplete() => [.. Catalogues.Where(type => IsOfErrors(type) && !OfStatuses.Contains(type.Name))
        .SelectMany(TextsOf).Where(text => !IsComplete(text.Text)).Select(text => text.Name).Distinct().Order(StringComparer.Ordinal)];

    static bool IsOfErrors(Type catalogue) => Errors().IsMatch(catalogue.Name);

    static bool IsComplete(string text) => Remedy().IsMatch(text) || Allowed().IsMatch(text);

    static IEnumerable<(string Name, string Text)> TextsOf(Type catalogue) =>
        catalogue.GetFields(BindingFlags.Public | BindingFlags.Static).Where(field => field.FieldType == typeof(string))
            .Select(field => ($"{catalogue.Name}.{field.Name}", (string)field.GetValue(null)))
            .Concat(MethodsOf(catalogue).SelectMany(method => new[] { true, false }.Select(flag => ($"{catalogue.Name}.{method.Name}", Call(method, flag)))))
            // A method returns null for a state without a problem.
            .Where(text => text.Item2 != null);

    static IEnumerable<MethodInfo> MethodsOf(Type catalogue) => catalogue.GetMethods(BindingFlags.Public | BindingFlags.Static)
        .Where(method => method.ReturnType == typeof(string) && method.GetParameters().All(parameter => IsSampled(parameter.ParameterType)));

    static bool IsSampled(Type type) => Samples.ContainsKey(type) || type.IsEnum || type == typeof(bool);

    static string Call(MethodInfo method, bool flag) => (string)method.Invoke(null, [.. method.GetParameters().Select(parameter =>
        parameter.ParameterType == typeof(bool) ? flag
        : parameter.ParameterType.IsEnum ? Enum.GetValues(parameter.ParameterType).GetValue(0) : Samples[parameter.ParameterType](parameter.Name))]);

    [GeneratedRegex("(?:Messages|Faults|Errors)$")]
    private static partial Regex Errors();

    // A verb that tells the user what to do, at the beginning of a clause; or a parameter with a remedy.
    [GeneratedRegex(@"(?:(?:^|[;:,.] )(?:then |and |or |so )?|\b(?:and|or|so) )(?:" + Verbs + @")\b|<(?:remedy|advice)>", RegexOptions.IgnoreCase)]
    private static partial Regex Remedy();

    [GeneratedRegex(@"\b(?:allowed|must|needs?|needed|required|expected|at least|at most|maximum|limit is|no more than|exactly|of the form)\b"
        + @"|\b(?:names are|Its topics|available (?:to|under)|begins with)\b|\bfrom \S+ to \S+")]
    private static partial Regex Allowed();

    // Two spaces within a line, a space before a punctuation mark, a brace of a format, or an empty text.
    [GeneratedRegex(@"\S  +\S| [,;:.](?!\w)|[{}]|^\s*$|;\s*;")]
    private static partial Regex Gap();
}
