using Nowpose.Anchoring;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Session.Hindcast;
using Nowpose.Sync;
using Nowpose.Unity;
using Nowpose.Unity.Cell;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Status;
using Nowpose.UnityPlayer;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Status;

/// <summary>Tests the panels of the scenes as seen from a head that looks horizontally.</summary>
[TestFixture("Samples~/HoloLens 2 (MRTK3)/HoloLens 2 (MRTK3).unity")]
[TestFixture("Samples~/Any OpenXR headset/Any OpenXR headset.unity")]
[TestFixture("Samples~/Display Calibration/Display Calibration.unity")]
public sealed class StatusPanelViewTests(string scene)
{
    PlayedCell _cell;
    StatusPanel _panel;
    PanelCells _cells;
    Transform _head;

    [SetUp]
    public void Begin()
    {
        _cell = new PlayedCell(RepositoryAssets.NewLibrary());
        _cell.Player.LoadScene(RepositoryFiles.Package + "/" + scene, roots =>
        {
            foreach (var session in roots.SelectMany(root => root.GetComponentsInChildren<MrilSession>(true)))
            {
                session.Settings = PlayedCell.Offline;
                session.With("_connectOnEnable", false);
            }
        });
        Run(1);
        _panel = _cell.Player.Find<StatusPanel>();
        _cells = _panel.Cells;
        _head = _cell.Player.Find<Camera>().transform;
    }

    [TearDown]
    public void End() => _cell.Dispose();

    void Run(double seconds) => _cell.Run(seconds, null);

    Transform Sheet => _panel.transform.Find("Cells");

    Bounds Ground => Sheet.Find("Ground").GetComponent<MeshRenderer>().bounds;

    IEnumerable<TextMesh> Texts => _panel.GetComponentsInChildren<TextMesh>().Where(text => text.text.Length > 0);

    [Test]
    public void Panel_EveryState_IsInViewWithCapitalsOfHalfADegree()
    {
        foreach (var (what, texts) in States())
        {
            _cells.Show(texts);

            Assert.That(Texts, Is.Not.Empty, what);
            foreach (var text in Texts)
            {
                foreach (var corner in SeenText.Corners(text)) Assert.That(SeenText.IsInView(corner, _head), $"{what}: {text.name} '{text.text}'");
                Assert.That(SeenText.CapitalDegrees(text, _head), Is.InRange(0.5f, 0.75f), $"{what}: {text.name} '{text.text}'");
            }
            Assert.That(SeenText.IsInView(Ground.min, _head) && SeenText.IsInView(Ground.max, _head), what + ": ground");
        }
    }

    [Test]
    public void Panel_EveryState_TextsFitTheirColumns()
    {
        foreach (var (what, texts) in States())
        {
            _cells.Show(texts);

            var sheet = Sheet;
            var cells = sheet.GetComponentsInChildren<TextMesh>().Where(text => text.text.Length > 0).ToList();
            foreach (var row in cells.GroupBy(cell => cell.name.Split(' ')[0]))
            {
                var places = row.OrderBy(cell => cell.transform.position.x).ToList();
                for (var i = 0; i < places.Count; i++)
                {
                    // Between two columns there must be a gap with the width of about one letter.
                    var end = i + 1 < places.Count ? places[i + 1].transform.position.x - 0.4f * sheet.lossyScale.x : Ground.max.x;
                    Assert.That(SeenText.Corners(places[i])[1].x, Is.LessThanOrEqualTo(end), $"{what}: {places[i].name} '{places[i].text}'");
                }
            }
            var tops = cells.Where(cell => !cell.name.StartsWith("Message", StringComparison.Ordinal)).Select(cell => cell.transform.position.y);
            var message = sheet.Find("Message 0").GetComponent<TextMesh>();
            if (message.text.Length > 0) Assert.That(SeenText.Corners(message)[2].y, Is.GreaterThanOrEqualTo(tops.Max()), what + ": message on top");
        }
    }

    [Test]
    public void Panel_AtItsPlace_IsAboutSixDegreesBelowTheHorizon()
    {
        _cells.Show(new StatusTexts());

        var middle = (Lowest() + SeenText.Elevation(Ground.max, _head)) / 2;

        Assert.That(middle, Is.EqualTo(-6).Within(1.5));
    }

    /// <summary>Returns the elevation in degrees of the lowest part of the panel, which is its background or the background of its bar.</summary>
    float Lowest() => _panel.GetComponentsInChildren<MeshRenderer>().Where(r => r.name == "Ground").Min(r => SeenText.Elevation(r.bounds.min, _head));

    [Test]
    public void Panel_Bar_IsInView()
    {
        Assert.That(Lowest(), Is.InRange(-14.5f, -10f));
    }

    IEnumerable<(string What, StatusTexts Texts)> States()
    {
        yield return ("nothing known", new StatusTexts());
        foreach (var pose in Enum.GetValues<PoseState>())
            foreach (var response in Enum.GetValues<OutsideRangeResponse>())
                yield return State($"{pose} {response}", new SessionStatistics { SettledPose = pose, OutsideRange = response });
        foreach (var state in Enum.GetValues<ClockState>())
            yield return State($"{state}", new SessionStatistics { Clock = new ClockModel(default, default, 0, Ms(888.8), state) });
        foreach (var ms in new[] { -888.8, 0.88, 88.8, 888.8, 1e9, -1e9 })
            yield return State($"{ms} ms", new SessionStatistics
            {
                ApplicationLatency = Ms(ms), ApplicationLatency95 = Ms(ms), VisualisationLatency = Ms(ms), Horizon = Ms(ms), RenderTime = Ms(ms),
                ToolError = new DisplayedError(600, ms, ms, 30, 60, ms, ms, 0.2, 0.1),
            });
        foreach (var method in Enum.GetValues<CalibrationMethod>())
            yield return State($"{method}", new SessionStatistics { Profile = new LatencyProfile(40.2, 1, "", 0, new DateTime(2026, 12, 28), method, 3) });
        yield return State("predicted", new SessionStatistics { IsLightPredicted = true });
        yield return State("inconsistent", new SessionStatistics { IsDisplayTimeInconsistent = true });
        foreach (var source in Enum.GetValues<RenderTimeSourceKind>()) yield return State($"{source}", new SessionStatistics { RenderTimeSource = source });
        foreach (var range in Enum.GetValues<RangeState>()) yield return State($"{range}", new SessionStatistics { Range = range });
        foreach (var reason in Enum.GetValues<RangeUnknownReason>()) yield return State($"{reason}", new SessionStatistics { RangeUnknownReason = reason });
        foreach (var reason in Enum.GetValues<ErrorWithheldReason>()) yield return State($"{reason}", new SessionStatistics { ErrorWithheld = reason });
        foreach (var security in Enum.GetValues<TransportSecurity>()) yield return State($"{security}", new SessionStatistics { Security = security });
        foreach (var link in new[] { LinkStatus.Idle, LinkStatus.Connecting, LinkStatus.Connected, LinkStatus.Waiting(new string('W', 700)) })
            yield return State($"{link.State}", new SessionStatistics { SyncLink = link, SampleLink = link });
        foreach (var match in Enum.GetValues<RobotDescriptionMatch>()) yield return State($"{match}", new SessionStatistics { RobotDescriptionMatch = match });
        foreach (var joints in new[] { 1, 7, 256 })
        {
            var statistics = new SessionStatistics();
            for (var i = 0; i < joints; i++)
                statistics.OwnRobot.JointStatuses.Add(new JointStatus(
                    "KUKA_LBR_IIWA_14_R820_joint_" + i, JointDataState.Fault, ControlTime.FromSeconds(1), TimeSpan.FromSeconds(i), new string('W', 256)));
            var texts = new StatusTexts();
            texts.Update(statistics, Network, "youbot", null);
            yield return ($"{joints} joints without data", texts);
        }
        foreach (var count in new[] { 1, 256 })
        {
            var parts = new ShownParts();
            for (var i = 0; i < count; i++) parts.Add(new Part("object WORKPIECE_WITH_A_LONG_NAME_" + i, new string('W', 128)));
            var texts = new StatusTexts();
            var statistics = new SessionStatistics { SettledPose = PoseState.Current, Now = ControlTime.FromSeconds(1010) };
            texts.Update(statistics, Network, "youbot", null, parts: parts);
            yield return ($"{count} objects that are not current", texts);
            foreach (var words in new[] { 1, 10, 20, 40, 60, 80, 200 })
            {
                texts = new StatusTexts();
                texts.Update(statistics, Network, "youbot", string.Join(" ", Enumerable.Repeat("WORD", words)), parts: parts);
                yield return ($"{count} objects that are not current and a message of {words} words", texts);
            }
        }
        foreach (var problem in new[] { "settings: missing", string.Join(" ", Enumerable.Repeat("the gateway at 192.168.100.200:47010", 30)) })
        {
            var texts = new StatusTexts();
            texts.Update(new SessionStatistics(), Network, "KUKA_LBR_IIWA_14_R820_WITH_A_GRIPPER", problem);
            yield return (problem, texts);
        }
    }

    static readonly SessionSettings Network =
        new(new ConnectionSettings("192.168.100.200", insecureLan: true), VisualisationLatency.FromMilliseconds(40));

    sealed record Part(string Title, string Fault) : IShownPart
    {
        public bool IsFaultCommon => false;
        public ControlTime? FaultSince => ControlTime.FromSeconds(1000);
    }

    static TimeSpan Ms(double ms) => TimeSpan.FromMilliseconds(ms);

    static (string, StatusTexts) State(string what, SessionStatistics statistics)
    {
        var texts = new StatusTexts();
        texts.Update(statistics, Network, "youbot", null);
        return (what, texts);
    }

    [Test]
    public void BaseRow_EveryState_FitsItsColumn()
    {
        var values = Enum.GetValues<BaseAnchorState>().Select(StatusMessages.Of);

        Assert.That(values.Max(SeenText.WidthOf), Is.LessThan(9.3f));
        Assert.That(SeenText.WidthOf("spread 88.8 mm 88.8°"), Is.LessThan(PanelCells.NoteWidth));
        Assert.That(SeenText.WidthOf("> 999 mm off"), Is.LessThan(PanelCells.NoteWidth));
    }
}
