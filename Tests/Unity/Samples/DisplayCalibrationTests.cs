using NUnit.Framework;
using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Latency;
using Nowpose.Latency.Load;
using Nowpose.Latency.Sweep;
using Nowpose.Unity;
using Nowpose.UnityPlayer;
using UnityEngine;

namespace Nowpose.Unity.Tests.Samples;

/// <summary>Tests the scene of the sample, with a shorter sweep, and with data from the test in place of a gateway.</summary>
public sealed class DisplayCalibrationTests
{
    PlayedCell _cell;
    MrilSession _session;
    LoadSweep _sweep;
    string _folder;

    [SetUp]
    public void Begin()
    {
        _folder = Path.Combine(Path.GetTempPath(), "nowpose-" + Guid.NewGuid().ToString("N"));
        _cell = new PlayedCell(RepositoryAssets.NewLibrary());
        _cell.Player.LoadScene("Packages/com.nowpose.mril/Samples~/Display Calibration/Display Calibration.unity", roots =>
        {
            _session = roots.SelectMany(root => root.GetComponents<MrilSession>()).Single().With("_connectOnEnable", false);
            _session.HeadsetClock = _cell.Clock;
            _sweep = _session.GetComponentInChildren<LoadSweep>(true).With("_folder", _folder)
                .With("_maxVertices", 300_000).With("_steps", 2).With("_secondsPerLoad", 0.5f).With("_settleSeconds", 0f);
        });
    }

    [TearDown]
    public async Task End()
    {
        _cell.Dispose();
        // Waits for the background thread that writes the log.
        await _sweep.Closed.Bounded();
        if (Directory.Exists(_folder)) Directory.Delete(_folder, recursive: true);
    }

    void Run(double seconds) => _cell.Run(seconds, _session, () => _cell.Player.World.Gpu.FrameTimings.Clear());

    [Test]
    public async Task Scene_Played_RunsTheSweepAndLogsTheShownCodes()
    {
        _cell.Player.World.Gpu.ConnectDisplay();
        _cell.Player.World.Gpu.DisplayGpuTime = 0.006f;
        Run(4.5);
        Assert.That(_session.GetComponentInChildren<TimestampDisplay>().FrameStart, Is.Not.Null);
        Run(8);
        await Soon.BecomesAsync(
            () =>
            {
                _cell.Frame(_session);
                return _sweep.Verdict != null;
            },
            "the sweep is evaluated");

        var rows = SweepTable.Read(_sweep.Path, out _);
        Assert.That(rows.Select(row => row.Vertices).Distinct(), Is.SupersetOf(new[] { 0, 150_000, 300_000 }));
        Assert.That(_sweep.Verdict.Sight, Is.EqualTo(LoadSight.Unseen), "the simulated GPU takes the same time for each load");
        Assert.That(WordsOf(_sweep), Is.EqualTo(_sweep.Words));
        Assert.That(_cell.Player.Logs.Where(log => log.Type is LogType.Error or LogType.Exception).Select(log => log.Message), Is.Empty);
    }

    static string WordsOf(LoadSweep sweep) => sweep.transform.Find("Words").GetComponent<TextMesh>().text;

    // The photo camera of a HoloLens 2 has a vertical field of view of about 40°. A code that fills a tenth of it can be read.
    [Test]
    public void Code_FromTheViewer_IsUprightAndLargeEnoughForACamera()
    {
        Run(5);
        var head = _cell.Player.Find<Camera>().transform;
        var code = _session.GetComponentInChildren<TimestampDisplay>().transform.Find("Timestamp").GetComponent<MeshRenderer>().bounds;

        var distance = Vector3.Distance(head.position, code.center);

        Assert.That(distance, Is.EqualTo(1).Within(0.05));
        Assert.That(code.size.y / (2 * distance * Math.Tan(21.5 * Math.PI / 180)), Is.GreaterThan(0.1));
        Assert.That(code.size.x, Is.EqualTo(0.1).Within(1e-4), "seen from the front");
    }

    [Test]
    public void Load_FromTheViewer_IsInViewBehindOtherObjects()
    {
        Run(5);
        _sweep.StopSweep();
        var load = _session.GetComponentInChildren<LoadGenerator>();
        load.Vertices = LoadMesh.MaxVertices;
        Run(4);
        var head = _cell.Player.Find<Camera>().transform;
        var panel = _cell.Player.Find<StatusPanel>().transform;

        Assert.That(load.IsReady);
        var patches = load.GetComponentsInChildren<MeshRenderer>();
        Assert.That(patches, Is.Not.Empty);
        foreach (var patch in patches)
        {
            var place = head.InverseTransformPoint(patch.bounds.center);
            // The smallest field of view of the supported displays is 43° by 29°.
            Assert.That(Math.Abs(place.x) + patch.bounds.extents.x, Is.LessThan(place.z * Math.Tan(21.5 * Math.PI / 180)));
            Assert.That(Math.Abs(place.y) + patch.bounds.extents.y, Is.LessThan(place.z * Math.Tan(14.5 * Math.PI / 180)));
            Assert.That(place.z, Is.GreaterThan(head.InverseTransformPoint(panel.position).z), "behind the panel");
        }
    }
}
