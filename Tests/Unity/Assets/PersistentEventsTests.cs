using Nowpose.UnityPlayer;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Events;

namespace Nowpose.Unity.Tests.Assets;

/// <summary>Tests the persistent calls of events in prefabs and scenes, including the events of MRTK3 that the sample sets.</summary>
public sealed class PersistentEventsTests
{
    Player _player;
    Probe _probe;

    static IEnumerable<string> Hierarchies => RepositoryFiles.All.Where(f => Path.GetExtension(f) is ".prefab" or ".unity");

    [SetUp]
    public void SetUp()
    {
        _player = new Player();
        _probe = new GameObject("Probe").AddComponent<Probe>();
    }

    [TearDown]
    public void TearDown() => _player.Dispose();

    [TestCaseSource(nameof(Hierarchies))]
    public void Events_InAPrefabOrScene_CallExistingPublicMethods(string path)
    {
        var faults = EventsOf(path).SelectMany(e => EventFaults.Of(e.Event).Select(fault => e.Place + " " + fault));

        Assert.That(faults, Is.Empty);
    }

    [TestCase("Headset Menu.prefab", 27)]
    [TestCase("Consent Prompt.prefab", 2)]
    [TestCase("Status Panel (MRTK3).prefab", 2)]
    [TestCase("HoloLens 2 (MRTK3).unity", 31)]
    public void Events_InTheSample_HaveTheExpectedNumberOfCalls(string file, int calls)
    {
        var path = Hierarchies.Single(h => h.EndsWith("/" + file, StringComparison.Ordinal));

        // Excludes the events of MRTK3's prefab HandMenuBase, which call objects of the same prefab.
        var own = EventsOf(path).Where(e => !e.Place.StartsWith("HandMenuBase ", StringComparison.Ordinal)).SelectMany(e => e.Event.Persistent.Calls);

        Assert.That(own.Count(), Is.EqualTo(calls));
    }

    [TestCase(nameof(Probe.Open), "Void", true)]
    [TestCase("Opne", "Void", false)]
    [TestCase(nameof(Probe.Open), "Float", false)]
    [TestCase(nameof(Probe.Turn), "Float", true)]
    [TestCase(nameof(Probe.Turn), "Void", false)]
    [TestCase(nameof(Probe.Turn), "EventDefined", false)]
    [TestCase("Hidden", "Void", false)]
    public void EventFaults_CallWithAStoredArgument_AreReportedIfInvalid(string method, string modeName, bool expected)
    {
        var mode = Enum.Parse<PersistentListenerMode>(modeName);
        _probe.Happened.Persistent.Add(PersistentCall.Of(_probe, method, mode, mode == PersistentListenerMode.Float ? 1f : null));

        var faults = EventFaults.EventsOf(_probe).SelectMany(e => EventFaults.Of(e.Event));

        Assert.That(faults.Count(), Is.EqualTo(expected ? 0 : 1));
    }

    [TestCase(nameof(Probe.Turn), true)]
    [TestCase(nameof(Probe.Open), false)]
    public void EventFaults_CallWithTheArgumentOfTheEvent_AreReportedIfIncompatible(string method, bool expected)
    {
        _probe.Turned.Persistent.Add(PersistentCall.Of(_probe, method, PersistentListenerMode.EventDefined, null));

        var faults = EventFaults.EventsOf(_probe).SelectMany(e => EventFaults.Of(e.Event));

        Assert.That(faults.Count(), Is.EqualTo(expected ? 0 : 1));
    }

    [Test]
    public void EventFaults_CallWithoutATarget_AreReported()
    {
        var gone = new GameObject("Gone").AddComponent<Probe>();
        _probe.Happened.Persistent.Add(PersistentCall.Of(gone, nameof(Probe.Open), PersistentListenerMode.Void, null));
        UnityEngine.Object.DestroyImmediate(gone);

        Assert.That(EventFaults.Of(_probe.Happened), Is.EqualTo(new[] { "calls Open of nothing" }));
    }

    static List<(string Place, UnityEventBase Event)> EventsOf(string path)
    {
        var library = RepositoryAssets.NewLibrary();
        var roots = Path.GetExtension(path) == ".unity" ? library.LoadScene(path).Roots : [library.Load<GameObject>(path)];
        return roots.SelectMany(r => r.GetComponentsInChildren<MonoBehaviour>(true)).SelectMany(EventFaults.EventsOf).ToList();
    }

    internal sealed class Probe : MonoBehaviour
    {
        [SerializeField] internal UnityEvent Happened = new();
        [SerializeField] internal UnityEvent<float> Turned = new();

        public void Open() { }

        public void Turn(float by) { }

        void Hidden() { }
    }
}
