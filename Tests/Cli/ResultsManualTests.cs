using System.Collections;
using System.Text.Json;
using System.Text.Json.Serialization.Metadata;
using System.Text.RegularExpressions;
using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Calibrate.Head;
using Nowpose.Cli.Calibrate.Range;
using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Cli.Demo;
using Nowpose.Cli.Demo.Paper;
using Nowpose.Cli.Headset;
using Nowpose.Cli.Replay;
using Nowpose.Headless.Tests.Cli.Calibrate;
using Nowpose.Headless.Tests.Cli.SessionFiles;
using Nowpose.Headless.Tests.Cli.Unity;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli;

/// <summary>Compares the keys and columns that the commands write with the page of the manual.</summary>
public sealed partial class ResultsManualTests : CalibrationFolder
{
    static readonly string Page = RepositoryFiles.Read(RepositoryFiles.Package + "/Documentation~/command-line-results.md");

    static readonly HashSet<string> Documented = [.. Names().Matches(Page).SelectMany(match => match.Groups[1].Value.Split('.'))];

    // The keys of these objects are names from the input.
    static readonly string[] WithOwnNames = ["links", "rounding"];

    [TestCase(typeof(DemoResult))]
    [TestCase(typeof(HeadsetResult))]
    public void Page_ResultWithAType_DocumentsEveryKey(Type type) => AssertDocumented(KeysOf(type));

    static IEnumerable<string> KeysOf(Type type)
    {
        var options = new JsonSerializerOptions
        {
            PropertyNamingPolicy = JsonNamingPolicy.SnakeCaseLower, TypeInfoResolver = new DefaultJsonTypeInfoResolver(),
        };
        // Properties with JsonIgnore have no getter here.
        return options.GetTypeInfo(type).Properties.Where(each => each.Get != null).SelectMany(each => KeysOf(Inner(each.PropertyType)).Prepend(each.Name));
    }

    // Returns the type of the items of a list.
    static Type Inner(Type type) =>
        type != typeof(string) && type.IsAssignableTo(typeof(IEnumerable)) && type.IsGenericType ? type.GetGenericArguments()[^1] : type;

    [Test]
    public async Task Page_Replay_DocumentsEveryKeyAndColumn()
    {
        var (frames, session) = (Path.Combine(Folder, "frames.csv"), Path.Combine(Folder, "session.jsonl"));
        VirtualRecording.To(session, seconds: 8, hasWork: true);
        var motion = Write("motion.csv", Rows("t_s,a", seconds => FormattableString.Invariant($"{Math.Sin(seconds)}")));
        var body = Write("body.csv", Rows("t_s,x,y,z,qx,qy,qz,qw", seconds => FormattableString.Invariant($"{Math.Sin(seconds)},0,0,0,0,0,1")));

        AssertDocumented(await KeysOf("replay", motion, "--predictor", "gp", "--phases", "2", "--json", "--frames", frames));
        AssertDocumented(await KeysOf("replay", body, "--phases", "2", "--json"));
        AssertDocumented(await KeysOf("replay", session, "--json"));
        AssertDocumented(File.ReadLines(frames).First().Split(','));
        AssertDocumented(await KeysOf("recommend", motion, "--json"));
    }

    [Test]
    public async Task Page_Sync_DocumentsEveryKeyAndColumn()
    {
        var log = Write("log.csv", ["t1_ns,t2_ns,t3_ns,t4_ns", "0,500000,500000,1000000"]);
        var (instants, page) = (Write("instants.csv", ["t_ns", "2000000"]), Path.Combine(Folder, "clock.html"));

        AssertDocumented(await KeysOf("sync", log, "--json", "--page", page));
        AssertDocumented(await KeysOf("sync", log, "--json", "--at", instants));
        AssertDocumented((await CliRun.OfAsync("sync", log)).Lines[0].Split(','));
        AssertDocumented((await CliRun.OfAsync("sync", log, "--at", instants)).Lines[0].Split(','));
        AssertDocumented(File.ReadLines(Path.ChangeExtension(page, ".csv")).First().Split(','));
    }

    [Test]
    public void Page_Paper_DocumentsEveryColumn()
    {
        using StringWriter frames = new(), exchanges = new();

        PaperOutput.WriteFrames(frames, []);
        PaperOutput.WriteExchanges(exchanges, []);

        AssertDocumented(frames.ToString().TrimEnd().Split(','));
        AssertDocumented(exchanges.ToString().TrimEnd().Split(','));
    }

    [Test]
    public async Task Page_Calibrate_DocumentsEveryKey()
    {
        var jog = Write("jog.csv", Rows(
            "t_s,robot,hologram", seconds => FormattableString.Invariant($"{Math.Sin(seconds)},{Math.Sin(seconds - 0.1)}")));

        AssertDocumented(await KeysOf("calibrate", "sine", jog, "--visu-ms", "40", "--json", "--out", Out));
        AssertDocumented(await KeysOf(
            "calibrate", "nudge", "--speed-mm-s", "250", "--forward-mm", "1", "--backward-mm", "-1", "--json", "--out", Out));
        AssertDocumented(KeysIn(new RangeFitResult(40, 1, 12, 12, 20, 15, 5, null).Json()));
        AssertDocumented(KeysIn(VlcJson.Of(new VlcResult([new PictureResult("a.jpg", 50, 10, 40, null), PictureResult.Not("b.jpg", "dark")]), null)));
        AssertDocumented(KeysIn(new HeadResult(new VlcResult(new SwungPictures { LatencyMs = 10 }.Take())).Json()));
    }

    [Test]
    public async Task Page_OtherCommands_DocumentsEveryKey()
    {
        using var project = new UnityProjectFolder(UnityManifests.Empty);

        AssertDocumented(KeysIn((await project.RunAsync("--json")).Output));
        AssertDocumented(await KeysOf("kinematics", "youbot", "--joints", "arm_joint_1=0", "--json"));
    }

    static IEnumerable<string> Rows(string header, Func<double, string> at) =>
        Enumerable.Range(0, 601).Select(i => FormattableString.Invariant($"{i / 50.0},{at(i / 50.0)}")).Prepend(header);

    static async Task<IReadOnlyList<string>> KeysOf(params string[] command)
    {
        var run = await CliRun.OfAsync(command);
        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        return KeysIn(run.Output);
    }

    static IReadOnlyList<string> KeysIn(string json)
    {
        using var result = JsonDocument.Parse(json);
        return [.. KeysIn(result.RootElement)];
    }

    static IEnumerable<string> KeysIn(JsonElement element) => element.ValueKind switch
    {
        JsonValueKind.Array => element.EnumerateArray().SelectMany(KeysIn),
        JsonValueKind.Object => element.EnumerateObject().SelectMany(
            property => (WithOwnNames.Contains(property.Name) ? [] : KeysIn(property.Value)).Prepend(property.Name)),
        _ => [],
    };

    static void AssertDocumented(IEnumerable<string> names)
    {
        var all = names.Distinct().ToList();
        Assert.That(all, Is.Not.Empty);
        Assert.That(all.Except(Documented), Is.Empty);
    }

    [GeneratedRegex(@"`\.?([\w.]+)`")]
    private static partial Regex Names();
}
