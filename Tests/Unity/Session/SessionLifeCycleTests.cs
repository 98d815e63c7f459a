using Nowpose.Gateway.Plants;
using Nowpose.Session;
using Nowpose.Unity;
using Nowpose.Unity.Status;
using Nowpose.UnityPlayer;
using NUnit.Framework;
using UnityEngine;
using Random = System.Random;

namespace Nowpose.Unity.Tests.Session;

/// <summary>
/// Tests that objects can be enabled, destroyed or created in any frame without an exception or a leak, and that an old pose never looks
/// current.
/// </summary>
public class SessionLifeCycleTests
{
    const int Steps = 600;

    // Messages that are correct after the destruction of an object that another object needs.
    static readonly string[] Losses =
        ["has no rig; move", "has no Text Mesh to copy", "is missing; name an object", "is drawn there; name an object"];

    [Test]
    public Task ApplicationEvents_RandomSequence_LeakNothing([NUnit.Framework.Range(1, 10)] int seed) => Play(seed, isShipped: false);

    [Test]
    public Task ApplicationEvents_RandomSequenceWithThePrefab_LeakNothing([NUnit.Framework.Range(1, 10)] int seed) => Play(seed, isShipped: true);

    static async Task Play(int seed, bool isShipped)
    {
        using var cell = new PlayedCell();
        Application.runInBackground = false;
        var (objects, subscribers) = (cell.Player.ObjectCount, cell.Player.SubscriberCount);
        var scene = new Scene(cell, new Random(seed), isShipped);

        for (var step = 0; step < Steps; step++)
        {
            var what = step % 100 == 0 ? scene.Restart() : scene.DoAnything();
            Assert.That(cell.Player.Logs.Where(IsFault), Is.Empty, $"seed {seed}, step {step}: {what}");
        }
        scene.Clear();

        Assert.That(cell.Player.SubscriberCount, Is.EqualTo(subscribers), $"seed {seed}: handlers");
        Assert.That(cell.Player.ObjectCount, Is.EqualTo(objects), $"seed {seed}: objects");
        Assert.That(scene.Currents, Is.GreaterThan(0), $"seed {seed}: it was current at times, or the test shows nothing");
        TestContext.Out.WriteLine($"{scene.Sessions.Count} sessions, {scene.Currents} current frames");
        foreach (var ended in scene.Sessions) await ended.Ended.Bounded();
        Assert.That(scene.Sessions.Select(ended => ended.SyncLink.State), Is.All.EqualTo(Nowpose.Network.LinkState.Idle), $"seed {seed}");
    }

    static bool IsFault(PlayerLogEntry log) =>
        log.Type is LogType.Exception or LogType.Error or LogType.Assert && !Losses.Any(log.Message.Contains);

    /// <summary>A cell with all components, and all events that can happen to it.</summary>
    sealed class Scene
    {
        readonly PlayedCell _cell;
        readonly Random _random;
        readonly bool _isShipped;
        readonly RobotDescriptionAsset[] _robots;
        readonly string[] _descriptions;
        readonly (string Name, Action Do)[] _actions;
        readonly HashSet<CompensationSession> _beforeThePause = [];
        readonly GameObject _viewer;
        GameObject _root;
        MrilSession _session;
        RobotRig _rig;
        VirtualGripper _gripper;
        Ghost _ghost;
        bool _isPaused, _isUnfocused;

        /// <param name="isShipped">Whether the cell is the prefab of the package; if false, the test builds the cell.</param>
        public Scene(PlayedCell cell, Random random, bool isShipped)
        {
            _cell = cell;
            _random = random;
            _isShipped = isShipped;
            var youBot = RobotFiles.LoadText("youbot");
            // The prefab contains a youBot and refuses any other robot, so its second description is a different URDF of a youBot.
            _descriptions = [youBot, isShipped ? youBot + "<!-- edited -->" : RobotFiles.LoadText("ur5")];
            _robots = [RobotDescriptionAsset.Create("one", _descriptions[0]), RobotDescriptionAsset.Create("other", _descriptions[1])];
            _viewer = new GameObject("Viewer", typeof(Camera)) { tag = "MainCamera" };
            _actions =
            [
                ("pause", () => Pause()),
                ("focus", () => Focus()),
                ("session on or off", () => Toggle(_session)),
                ("rig on or off", () => Toggle(_rig)),
                ("gripper on or off", () => Toggle(_gripper)),
                ("cell in or out", () => ToggleActive(_root)),
                ("rig in or out", () => ToggleActive(_rig)),
                ("gripper in or out", () => ToggleActive(_gripper)),
                ("ghost in or out", () => ToggleActive(_ghost)),
                ("settings", () => Session(session => session.Settings = PlayedCell.Offline)),
                ("robot", () => Session(session => session.RobotAsset = _random.Next(3) is var i and < 2 ? _robots[i] : null)),
                ("description", () => Session(session => session.Session?.Described(_descriptions[_random.Next(2)]))),
                ("connect", () => Session(session => session.Connect())),
                ("disconnect", () => Session(session => session.Disconnect())),
                ("a session less", () => Destroy(_session)),
                ("a rig less", () => Destroy(_rig == null ? null : _rig.gameObject)),
                ("a rig's script less", () => Destroy(_rig)),
                ("a gripper less", () => Destroy(_gripper == null ? null : _gripper.gameObject)),
                ("any script on or off", () => Toggle(AnyScript())),
                ("any object in or out", () => ToggleActive(AnyScript())),
                ("any script less", () => Destroy(AnyScript())),
                ("any object less", () => Destroy(AnyObject())),
                ("the viewer turns", () => _viewer.transform.rotation = Quaternion.Euler(0, _random.Next(360), 0)),
                ("the viewer on or off", () => ToggleActive(_viewer)),
                ("a cell less", () => Destroy(_root)),
                ("a new cell", () => Rebuild()),
            ];
        }

        /// <summary>All sessions that have been created so far.</summary>
        public HashSet<CompensationSession> Sessions { get; } = [];

        /// <summary>Number of frames whose pose was current.</summary>
        public int Currents { get; private set; }

        public string Restart()
        {
            if (_isPaused) Pause();
            if (_isUnfocused) Focus();
            Rebuild();
            return "a new cell, and " + Frames(300);
        }

        public string DoAnything()
        {
            // Most steps only run frames. 150 frames are long enough to synchronise the clock in some cases.
            if (_random.Next(4) > 0) return Frames(_random.Next(5) == 0 ? 150 : _random.Next(1, 4));
            var (name, action) = _actions[_random.Next(_actions.Length)];
            action();
            Note();
            return name;
        }

        public void Clear()
        {
            Destroy(_root);
            Destroy(_viewer);
            foreach (var robot in _robots) Destroy(robot);
            _cell.Frame(null);
        }

        string Frames(int count)
        {
            for (var i = 0; i < count; i++)
            {
                _cell.Frame(_session);
                Note();
            }
            return count + " frames";
        }

        void Rebuild()
        {
            Destroy(_root);
            if (_isShipped) Instantiate();
            else MakeByHand();
            _root = _session.gameObject;
            _session.RobotAsset = _robots[0];
            _session.Shown += NoteShown;
            _root.SetActive(true);
        }

        void MakeByHand()
        {
            _session = _cell.NewSession(robot: null);
            var anchor = Below<BaseAnchor>(_session.transform);
            _rig = Below<RobotRig>(anchor.transform);
            _gripper = Below<VirtualGripper>(_rig.transform);
            _ghost = Below<Ghost>(anchor.transform);
            _ghost.GetComponent<RobotRig>().With("_shows", RigPose.Held);
        }

        void Instantiate()
        {
            _session = _cell.NewSessionOf("Nowpose Robot Cell");
            _rig = _session.GetComponentsInChildren<RobotRig>(true).Single(rig => rig.Shows == RigPose.Displayed);
            _gripper = _rig.GetComponentInChildren<VirtualGripper>(true);
            _ghost = _session.GetComponentInChildren<Ghost>(true);
            Assert.That(_session.GetComponentInChildren<StatusPanel>(true), Is.Not.Null);
            Assert.That(_session.GetComponentInChildren<RenderTimeSource>(true), Is.Not.Null);
        }

        // Returns a random object below the cell, which may be a link, a finger or a label.
        GameObject AnyObject()
        {
            if (_root == null) return null;
            var all = _root.GetComponentsInChildren<Transform>(true);
            return all[_random.Next(all.Length)].gameObject;
        }

        // Returns a random script of the cell. Excludes a rig that a ghost requires, because Unity refuses to remove it.
        MonoBehaviour AnyScript()
        {
            if (_root == null) return null;
            var scripts = _root.GetComponentsInChildren<MonoBehaviour>(true);
            var script = scripts.Length == 0 ? null : scripts[_random.Next(scripts.Length)];
            return script is RobotRig && script.GetComponent<Ghost>() is { } ghost && ghost != null ? ghost : script;
        }

        static T Below<T>(Transform parent) where T : Component
        {
            var made = new GameObject(typeof(T).Name);
            made.SetActive(false);
            made.transform.SetParent(parent, false);
            var component = made.AddComponent<T>();
            made.SetActive(true);
            return component;
        }

        void Note()
        {
            if (_session != null && _session.Session != null) Sessions.Add(_session.Session);
        }

        void Pause()
        {
            _cell.Player.Pause(_isPaused = !_isPaused);
            if (_isPaused) _beforeThePause.UnionWith(Sessions);
        }

        void Focus() => _cell.Player.Focus(!(_isUnfocused = !_isUnfocused));

        void NoteShown(DisplayFrame frame)
        {
            // Runs in every frame, so a constraint would take a tenth of the time.
            if (_beforeThePause.Contains(_session.Session)) Assert.Fail("a session from before the pause");
            if (frame.State == PoseState.Current) Currents++;
        }

        void Session(Action<MrilSession> action)
        {
            if (_session != null) action(_session);
        }

        static void Toggle(Behaviour behaviour)
        {
            if (behaviour != null) behaviour.enabled = !behaviour.enabled;
        }

        static void ToggleActive(Component component) => ToggleActive(component == null ? null : component.gameObject);

        static void ToggleActive(GameObject gameObject)
        {
            if (gameObject != null) gameObject.SetActive(!gameObject.activeSelf);
        }

        static void Destroy(UnityEngine.Object doomed)
        {
            if (doomed != null) UnityEngine.Object.Destroy(doomed);
        }
    }
}
