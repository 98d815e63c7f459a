using Nowpose.Latency;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Calibration;

public sealed class TimestampDisplayTests
{
    PlayedCell _cell;
    MrilSession _session;
    TimestampDisplay _display;

    [SetUp]
    public void Begin() => _cell = new PlayedCell();

    [TearDown]
    public void End() => _cell.Dispose();

    void Play(double seconds = 5, bool rewrites = false, string robot = "youbot")
    {
        _session = _cell.NewSession(robot, new SessionSettings(
            PlayedCell.Offline.Connection, PlayedCell.Offline.Visualisation, rewriteBeforeRender: rewrites));
        var model = new GameObject("Model");
        model.transform.SetParent(_session.transform, worldPositionStays: false);
        model.AddComponent<MeshRenderer>();
        _display = _session.gameObject.AddComponent<TimestampDisplay>()
            .With("_light", new Material((Shader)null)).With("_cell", model.AddComponent<TextMesh>());
        _session.gameObject.SetActive(true);
        _cell.Run(seconds, _session);
    }

    MeshRenderer Code => _display.transform.Find("Timestamp").GetComponent<MeshRenderer>();

    /// <summary>Returns which squares of the code are lit, by testing a point of each square against the triangles of the mesh.</summary>
    bool[] Lit()
    {
        var mesh = Code.GetComponent<MeshFilter>().sharedMesh;
        var (vertices, triangles) = (mesh.vertices, mesh.triangles);
        var lit = new bool[TimestampCode.CellCount];
        if (!Code.enabled) return lit;
        for (var cell = 0; cell < lit.Length; cell++)
        {
            // The point is near the middle of the square, but not on the diagonal between its two triangles.
            var x = ((cell % 8 + 0.52) / 8 - 0.5) * 0.1;
            var y = (0.5 - (cell / 8 + 0.47) / 8) * 0.1;
            for (var i = 0; i < triangles.Length; i += 3)
                lit[cell] |= Holds(vertices[triangles[i]], vertices[triangles[i + 1]], vertices[triangles[i + 2]], x, y);
        }
        return lit;
    }

    // Returns whether a triangle contains a point. Only triangles that are clockwise as seen from −z (x right, y up) are visible.
    static bool Holds(Vector3 a, Vector3 b, Vector3 c, double x, double y) => Right(a, b, x, y) && Right(b, c, x, y) && Right(c, a, x, y);

    static bool Right(Vector3 a, Vector3 b, double x, double y) => (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x) < 0;

    static bool[] Drawn(int value)
    {
        var cells = new bool[TimestampCode.CellCount];
        TimestampCode.Draw(value, CodeKind.Headset, cells);
        return cells;
    }

    string Text => string.Concat(_display.transform.Find("Timestamp").GetComponentsInChildren<TextMesh>()
        .Where(t => t.name.StartsWith("Letter", StringComparison.Ordinal)).OrderBy(t => t.transform.localPosition.x).Select(t => t.text));

    string Words => _display.transform.Find("Timestamp/Words").GetComponent<TextMesh>().text;

    // Compares the code that a camera sees with the start of the displayed frame, converted with the true clocks of the cell.
    [TestCase(false)]
    [TestCase(true)]
    public void Code_EachFrame_IsTheControlTimeOfItsStart(bool rewrites)
    {
        Play(rewrites: rewrites);
        HeadsetTime? start = null;
        _session.Shown += frame => start = frame.Start;
        _cell.Clock.Step = TimeSpan.FromMilliseconds(1.7);

        for (var i = 0; i < 90; i++)
        {
            _cell.Run(0.001, _session);

            var truth = new ControlTime(start.Value.SinceEpoch + TimeSpan.FromSeconds(300));
            Assert.That((_display.FrameStart.Value - truth).Duration(), Is.LessThan(TimeSpan.FromMilliseconds(0.1)));
            Assert.That(Lit(), Is.EqualTo(Drawn(TimestampCode.ValueOf(_display.FrameStart.Value))), "frame " + i);
        }
    }

    [Test]
    public void Text_EachFrame_IsTheTimeOfItsStartWithMilliseconds()
    {
        Play();

        var ms = Math.Floor(_display.FrameStart.Value.SinceEpoch.TotalMilliseconds);

        Assert.That(Text, Is.EqualTo((ms / 1000).ToString("0.000", System.Globalization.CultureInfo.InvariantCulture) + "s"));
        Assert.That(Words, Is.Empty);
    }

    [Test]
    public void Clock_NotSynchronised_ShowsOnlyAMessage()
    {
        _cell.IsSyncUp = false;

        Play();

        Assert.That(Lit(), Is.Not.Empty.And.All.False);
        Assert.That(Text, Is.Empty);
        Assert.That(Words, Is.EqualTo(StatusMessages.ClockNotSynchronised));
        Assert.That(_display.FrameStart, Is.Null);
    }

    [Test]
    public void Clock_Lost_HidesTheCode()
    {
        Play(10);
        Assert.That(Code.enabled);

        _cell.IsSyncUp = false;
        _cell.Run(3, _session);

        Assert.That(Lit(), Is.Not.Empty.And.All.False);
        Assert.That(Words, Is.EqualTo(StatusMessages.ClockNotSynchronised));
    }

    [Test]
    public void Robot_Unknown_ShowsOnlyAMessage()
    {
        Play(robot: null);

        Assert.That(Lit(), Is.Not.Empty.And.All.False);
        Assert.That(Words, Is.EqualTo(StatusMessages.NoSession));
    }

    [Test]
    public void Session_Paused_ShowsOnlyAMessageUntilResumed()
    {
        Play();

        _cell.Player.Pause(true);
        Assert.That(Words, Is.EqualTo(StatusMessages.NoSession));
        Assert.That(Lit(), Has.All.False);

        _cell.Player.Pause(false);
        _cell.Run(5, _session);
        Assert.That(Lit(), Is.EqualTo(Drawn(TimestampCode.ValueOf(_display.FrameStart.Value))));
    }

    [TestCase(false)]
    [TestCase(true)]
    public void Frames_AfterWarmUp_AllocateNothing(bool rewrites)
    {
        Play(20, rewrites);
        _display.enabled = false;
        _cell.Run(1, _session);
        var without = _cell.AllocatedIn(() => _cell.Run(3, _session));
        _display.enabled = true;
        _cell.Run(1, _session);

        var allocated = _cell.AllocatedIn(() => _cell.Run(3, _session));

        Assert.That(_display.FrameStart, Is.Not.Null);
        Assert.That(allocated, Is.EqualTo(without));
    }

    [Test]
    public void OnDisable_WhileShown_RemovesItsObjects()
    {
        Play();
        var mesh = Code.GetComponent<MeshFilter>().sharedMesh;

        _display.enabled = false;
        _cell.Run(0.1, _session);

        Assert.That(_display.transform.Find("Timestamp"), Is.EqualTo(null));
        Assert.That(!mesh, "destroyed");
        Assert.That(_display.FrameStart, Is.Null);
    }

    // A camera would read the old time of a code that stays lit.
    [Test]
    public void OnDisable_ByAnEarlierListenerOfTheFrame_RemovesItsObjects()
    {
        var isOff = false;
        _session = _cell.NewSession();
        _session.Shown += _ =>
        {
            if (isOff) _display.enabled = false;
        };
        _display = _session.gameObject.AddComponent<TimestampDisplay>().With("_light", new Material((Shader)null));
        _session.gameObject.SetActive(true);
        _cell.Run(5, _session);
        Assert.That(Code.enabled);

        isOff = true;
        _cell.Run(0.1, _session);

        Assert.That(_display.transform.Find("Timestamp"), Is.EqualTo(null));
        Assert.That(_display.FrameStart, Is.Null);
    }

    [Test]
    public void Session_Missing_IsLogged()
    {
        new GameObject("Alone").AddComponent<TimestampDisplay>();

        _cell.Run(0.1, null);

        Assert.That(_cell.Messages, Has.Some.Contains(ComponentMessages.ComponentWithoutSession("timestamp display", "Alone")));
        Assert.That(_cell.Messages, Has.Some.Contains(ComponentMessages.DisplayWithoutMaterial("Alone")));
    }

    [Test]
    public void Objects_Deleted_AreMadeAgain()
    {
        Play();

        UnityEngine.Object.DestroyImmediate(Code.gameObject);
        _cell.Run(0.1, _session);

        Assert.That(Code.enabled);
        Assert.That(_cell.Player.Logs.Count(log => log.Type == LogType.Exception), Is.Zero);
    }

    [Test]
    public void Text_WithTheNameOfTheObjects_IsKept()
    {
        var session = _cell.NewSession();
        var text = new GameObject("Timestamp").AddComponent<TextMesh>();
        text.transform.SetParent(session.transform, worldPositionStays: false);
        session.gameObject.AddComponent<TimestampDisplay>().With("_light", new Material((Shader)null)).With("_cell", text);
        session.gameObject.SetActive(true);

        _cell.Run(1, session);

        Assert.That(text != null);
    }
}
