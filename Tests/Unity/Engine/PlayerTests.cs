using Nowpose.Unity.Tests.Engine.Scripts;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Engine;

public sealed class PlayerTests : PlayerFixture
{
    [Test]
    public void Step_GivenTimes_SetUnitysTimes()
    {
        Player.Step(2);
        Assert.That((Time.time, Time.frameCount), Is.EqualTo((2f, 1)));
        Assert.That(Time.unscaledDeltaTime, Is.EqualTo(0.02f));

        Player.Step(2.25);
        Assert.That((Time.time, Time.unscaledTimeAsDouble, Time.realtimeSinceStartupAsDouble), Is.EqualTo((2.25f, 2.25, 2.25)));
        Assert.That(Time.frameCount, Is.EqualTo(2));
        Assert.That(Time.unscaledDeltaTime, Is.EqualTo(0.25f));
    }

    [Test]
    public void Step_AfterAStall_ScaledTimeAdvancesByTheMaximum()
    {
        Player.Step(0);

        Player.Step(5);

        Assert.That(Time.time, Is.EqualTo(1f / 3).Within(1e-6));
        Assert.That((Time.unscaledDeltaTime, Time.realtimeSinceStartup), Is.EqualTo((5f, 5f)));
    }

    [TestCase(0.5)]
    [TestCase(double.NaN)]
    public void Step_Backwards_IsRefused(double time)
    {
        Player.Step(1);

        Assert.That(() => Player.Step(time), Throws.TypeOf<ArgumentOutOfRangeException>());
    }

    [Test]
    public void Step_WithScripts_AllocatesNothingAfterWarmUp()
    {
        for (var i = 0; i < 20; i++) new GameObject("a").AddComponent<Silent>();
        Add<Camera>("c");
        Application.onBeforeRender += Nothing;
        Frame(3);

        var before = GC.GetAllocatedBytesForCurrentThread();
        Player.Step(1);
        Player.Step(2);

        Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
        Assert.That(Player.Find<Silent>().Frames, Is.GreaterThan(0));
    }

    [Test]
    public void LoadScene_SecondScene_DestroysTheFirst()
    {
        var first = Detached("first");
        Player.LoadScene([first]);
        Journal.Take();

        var second = Detached("second");
        Player.LoadScene([second]);

        Assert.That(Journal.Take(), Is.EqualTo("first.OnDisable first.OnDestroy second.Awake second.OnEnable"));
        Assert.That(first == null);
        Assert.That(second.scene.GetRootGameObjects(), Is.EqualTo(new[] { second }));
    }

    [Test]
    public void Logs_FromAnyThread_AreKeptWithTheirContext()
    {
        var a = new GameObject("a");

        Debug.LogWarning("careful", a);
        var thread = new Thread(() => Debug.LogError("far"));
        thread.Start();
        thread.Join();

        Assert.That(Player.Logs.Select(l => (l.Type, l.Message)), Is.EqualTo(new[] { (LogType.Warning, "careful"), (LogType.Error, "far") }));
        Assert.That(Player.Logs[0].Context, Is.SameAs(a));
    }

    [Test]
    public void SubscriberCount_SubscriberRemoved_DoesNotCountIt()
    {
        Application.onBeforeRender += Nothing;
        Application.logMessageReceived += Nothing;
        Assert.That(Player.SubscriberCount, Is.EqualTo(2));

        Application.onBeforeRender -= Nothing;
        Application.logMessageReceived -= Nothing;

        Assert.That(Player.SubscriberCount, Is.Zero);
    }

    [Test]
    public void Dispose_Twice_HasNoEffectAndStepIsRefused()
    {
        Player.Dispose();
        Player.Dispose();

        Assert.That(() => Player.Step(1), Throws.TypeOf<ObjectDisposedException>());
        Assert.That(Application.isPlaying, Is.False);
        Assert.That(Player.ObjectCount, Is.Zero);
    }

    [Test]
    public void Step_OneOfTwoPlayers_AdvancesOnlyThatPlayer()
    {
        Add<Recorder>("a");
        Journal.Take();
        using var second = new Nowpose.UnityPlayer.Player();
        Add<Recorder>("b");
        Journal.Take();

        Assert.That(Frame(), Is.EqualTo("a.Start a.Update a.LateUpdate"));
        second.Step(7);
        Assert.That(Journal.Take(), Is.EqualTo("b.Start b.Update b.LateUpdate"));
        Assert.That(Time.time, Is.EqualTo(7));
        Assert.That(second.Find<Recorder>().name, Is.EqualTo("b"));
    }

    static GameObject Detached(string name)
    {
        var made = GameObject.Detached(name);
        made.Add(typeof(Recorder));
        return made;
    }

    static void Nothing() { }

    static void Nothing(string message, string trace, LogType type) { }

    sealed class Silent : MonoBehaviour
    {
        public int Frames { get; private set; }

        void Update() => Frames++;
        void LateUpdate() => transform.localPosition = Vector3.one;
    }
}
