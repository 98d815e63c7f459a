using System.Reflection;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Rendering;

public class PoseAppearanceTests
{
    PlayedCell _cell;
    MrilSession _session;
    Action<int> _eachFrame;
    int _frames;
    RobotRig _rig;
    PoseAppearance _appearance;
    Renderer _tool;
    TextMesh _words;
    Transform _viewer;

    [SetUp]
    public void Begin()
    {
        _cell = new PlayedCell();
        _session = _cell.NewSession(settings: new SessionSettings(
            new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(40),
            range: new ConstantLatencyRange(15, RenderTimeSourceKind.DisplayGpuTime)));
        _eachFrame = null;
        _frames = 0;
        _rig = Child("Robot", _session.gameObject.transform).AddComponent<RobotRig>();
        _tool = Part("Tool", _rig.transform);
        _words = Child("Words", _rig.transform).AddComponent<TextMesh>();
        _words.gameObject.AddComponent<MeshRenderer>();
        _words.fontSize = 64;
        _appearance = _rig.gameObject.AddComponent<PoseAppearance>().With("_words", _words);
        _viewer = new GameObject("Camera") { tag = "MainCamera" }.AddComponent<Camera>().transform;
        _viewer.position = new Vector3(0, 1.6f, -2);
    }

    [TearDown]
    public void End() => _cell.Dispose();

    void Play(double seconds)
    {
        _session.gameObject.SetActive(true);
        Run(seconds);
    }

    void Run(double seconds) => _cell.Run(seconds, _session, () => _eachFrame?.Invoke(_frames++));

    static GameObject Child(string name, Transform parent)
    {
        var child = new GameObject(name);
        child.transform.SetParent(parent, false);
        return child;
    }

    static Renderer Part(string name, Transform parent)
    {
        var material = new Material((Shader)null) { name = name };
        material.SetFloat("_Fade", 0);
        material.SetFloat("_Hatch", 0);
        var part = Child(name, parent).AddComponent<MeshRenderer>();
        part.sharedMaterial = material;
        return part;
    }

    (float Fade, float Hatch) Look(Renderer renderer)
    {
        var block = new MaterialPropertyBlock();
        renderer.GetPropertyBlock(block);
        return (block.GetFloat(Shader.PropertyToID("_Fade")), block.GetFloat(Shader.PropertyToID("_Hatch")));
    }

    void Take(double ms)
    {
        for (var i = 0; i < 20; i++) _session.Session.Rendered(TimeSpan.FromMilliseconds(ms), RenderTimeSourceKind.DisplayGpuTime);
    }

    void BeCurrent()
    {
        Play(5);
        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.Current));
    }

    [Test]
    public void Show_Current_IsDrawnUnchangedWithoutWords()
    {
        BeCurrent();

        Assert.That(_tool.isVisible, Is.True);
        Assert.That(Look(_tool), Is.EqualTo((0f, 0f)));
        Assert.That(_words.text, Is.Empty);
    }

    [Test]
    public void Show_BeforeTheFirstPositions_DrawsOnlyTheWords()
    {
        _cell.IsPlantUp = false;
        var wasVisible = new List<bool>();
        _eachFrame = _ => wasVisible.Add(_tool.isVisible);

        Play(2);

        Assert.That(wasVisible, Is.All.False, "not in the first frame either");
        Assert.That(_words.text, Is.EqualTo("no positions yet"));
        Assert.That(_words.GetComponent<Renderer>().isVisible, Is.True);
    }

    [Test]
    public void Show_NotSynchronised_IsFaintStripedWithWords()
    {
        _cell.IsSyncUp = false;

        Play(2);

        Assert.That(_tool.isVisible, Is.True);
        Assert.That(Look(_tool).Fade, Is.GreaterThan(0.5));
        Assert.That(Look(_tool).Hatch, Is.EqualTo(1));
        Assert.That(_words.text, Is.EqualTo("not synchronised"));
    }

    [Test]
    public void Show_RigCannotShowTheRobot_IsNotDrawn()
    {
        // The root link alone counts as a hierarchy, with missing links.
        Child("arm_link_0", _rig.transform);

        Play(5);

        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.Current));
        Assert.That(_tool.isVisible, Is.False);
        Assert.That(_words.text, Is.EqualTo("rig not moved"));
    }

    [Test]
    public void Show_RigDisabled_IsNotDrawnUntilEnabled()
    {
        BeCurrent();

        _rig.enabled = false;
        Run(0.1);
        Assert.That(_tool.isVisible, Is.False);
        _rig.enabled = true;
        Run(0.1);

        Assert.That(_tool.isVisible, Is.True);
        Assert.That(_words.text, Is.Empty);
    }

    [TestCase(false, false)]
    [TestCase(true, false)]
    [TestCase(false, true)]
    public void Show_RigDestroyed_ItsPartsAreNotDrawn(bool refreshed, bool enabledAgain)
    {
        BeCurrent();
        var arm = _rig.Link("arm_link_2").GetComponentInChildren<MeshRenderer>();
        Assert.That(arm.isVisible, Is.True);

        UnityEngine.Object.Destroy(_rig);
        Run(0.1);
        if (refreshed) _appearance.Refresh();
        if (enabledAgain) _appearance.enabled = false;
        if (enabledAgain) _appearance.enabled = true;
        Run(0.1);

        Assert.That(_session.Frame.State, Is.EqualTo(PoseState.Current));
        Assert.That(_tool.isVisible, Is.False);
        Assert.That(_words.text, Is.EqualTo("rig not moved"));
    }

    [Test]
    public void Show_WithoutRig_DrawsAccordingToThePose()
    {
        var sign = Part("Sign", _session.transform);
        sign.gameObject.AddComponent<PoseAppearance>();

        BeCurrent();

        Assert.That(sign.isVisible, Is.True);
    }

    /// <summary>Mounts a gripper with its own appearance outside the rig's hierarchy.</summary>
    (VirtualGripper Gripper, Renderer Part, TextMesh Words) MountElsewhere(string flange = "")
    {
        var gripper = Child("Gripper", _session.transform).AddComponent<VirtualGripper>().With("_rig", _rig).With("_flangeLink", flange);
        var part = Part("Palm", gripper.transform);
        var words = Child("Gripper's Words", gripper.transform).AddComponent<TextMesh>();
        words.gameObject.AddComponent<MeshRenderer>();
        gripper.gameObject.AddComponent<PoseAppearance>().With("_words", words);
        return (gripper, part, words);
    }

    [Test]
    public void Show_GripperOnAnotherRig_DrawsAccordingToThePose()
    {
        var (_, part, words) = MountElsewhere();

        BeCurrent();

        Assert.That(part.isVisible, Is.True);
        Assert.That(words.text, Is.Empty);
    }

    [TestCase("rig disabled")]
    [TestCase("rig destroyed")]
    [TestCase("rig refused")]
    [TestCase("flange unknown")]
    [TestCase("gripper disabled")]
    [TestCase("gripper destroyed")]
    public void Show_GripperOnARigThatDoesNotFollow_IsNotDrawn(string trouble)
    {
        if (trouble == "rig refused") Child("arm_link_0", _rig.transform);
        var (gripper, part, words) = MountElsewhere(trouble == "flange unknown" ? "hand" : "");

        BeCurrent();
        if (trouble == "rig disabled") _rig.enabled = false;
        if (trouble == "rig destroyed") UnityEngine.Object.Destroy(_rig);
        if (trouble == "gripper disabled") gripper.enabled = false;
        if (trouble == "gripper destroyed") UnityEngine.Object.Destroy(gripper);
        Run(0.1);

        Assert.That(part.isVisible, Is.False);
        Assert.That(words.text, Is.EqualTo("gripper not moved"));
    }

    [Test]
    public void Show_GripperBelowTheRigIsDisabled_DrawsOnlyTheArm([Values] bool destroyed)
    {
        var gripper = Child("Gripper", _rig.transform).AddComponent<VirtualGripper>();
        var part = Part("Palm", gripper.transform);
        BeCurrent();
        Assert.That(part.isVisible, Is.True);

        if (destroyed) UnityEngine.Object.Destroy(gripper);
        else gripper.enabled = false;
        Run(0.1);
        _appearance.Refresh();

        Assert.That(part.isVisible, Is.False);
        Assert.That(_tool.isVisible, Is.True);
        Assert.That(_words.text, Is.EqualTo("gripper not moved"));
    }

    [Test]
    public void Show_GripperObjectInactive_HasNoWords()
    {
        var gripper = Child("Gripper", _rig.transform).AddComponent<VirtualGripper>();
        BeCurrent();

        gripper.gameObject.SetActive(false);
        Run(0.1);

        Assert.That(_words.text, Is.Empty);
    }

    [Test]
    public void Show_SamplesStop_IsFaintStripedWithWordsUntilTheyReturn()
    {
        BeCurrent();

        _cell.IsPlantUp = false;
        Run(1);
        var (held, words) = (Look(_tool), _words.text);
        _cell.IsPlantUp = true;
        Run(1);

        Assert.That(held.Fade, Is.GreaterThan(0.2));
        Assert.That(held.Hatch, Is.EqualTo(1));
        Assert.That(words, Is.EqualTo("held"));
        Assert.That(Look(_tool), Is.EqualTo((0f, 0f)));
        Assert.That(_words.text, Is.Empty);
    }

    [Test]
    public void Show_OutsideRange_IsFaintStripedWithWords()
    {
        BeCurrent();

        Take(30);
        _cell.Frame(_session);

        Assert.That(Look(_tool).Fade, Is.GreaterThan(0.2));
        Assert.That(Look(_tool).Hatch, Is.EqualTo(1));
        Assert.That(_words.text, Is.EqualTo("outside range"));
    }

    [Test]
    public void Abandon_Paused_IsDrawnAsNotCurrent()
    {
        BeCurrent();

        _cell.Player.Pause(true);
        var paused = (Look(_tool), _words.text, _tool.isVisible);
        _cell.Player.Pause(false);
        _cell.Frame(_session);
        var resumed = _words.text;
        Run(5);

        Assert.That(paused.Item1.Hatch, Is.EqualTo(1), "at once, no frame need come");
        Assert.That(paused.text, Is.EqualTo("no session"));
        Assert.That(paused.isVisible, Is.True);
        Assert.That(resumed, Is.EqualTo("no positions yet").Or.EqualTo("not synchronised"));
        Assert.That(Look(_tool), Is.EqualTo((0f, 0f)));
    }

    [Test]
    public void Abandon_BeforeTheFirstPositions_IsNotDrawn()
    {
        _cell.IsPlantUp = false;
        Play(0.5);

        _session.enabled = false;
        _cell.Frame(_session);

        Assert.That(_tool.isVisible, Is.False);
    }

    [Test]
    public void Refresh_RigBuiltAtRunTime_IncludesItsParts()
    {
        _cell.IsPlantUp = false;

        Play(0.5);

        var built = _rig.GetComponentsInChildren<Renderer>().Where(r => r != _tool && r.gameObject != _words.gameObject).ToList();
        Assert.That(_rig.Model, Is.Not.Null);
        Assert.That(built.Select(r => r.isVisible), Is.All.False);
    }

    [Test]
    public void Show_UsersOwnProperties_AreKept()
    {
        var block = new MaterialPropertyBlock();
        block.SetFloat("_Own", 7);
        _tool.SetPropertyBlock(block);

        BeCurrent();

        _tool.GetPropertyBlock(block);
        Assert.That(block.GetFloat("_Own"), Is.EqualTo(7));
    }

    [Test]
    public void Show_RendererDisabledByTheUser_StaysDisabled()
    {
        _tool.enabled = false;

        BeCurrent();

        Assert.That(_tool.enabled, Is.False);
        Assert.That(_tool.isVisible, Is.False);
    }

    [Test]
    public void LateUpdate_Words_FaceTheViewerAndAreReadable()
    {
        _cell.IsPlantUp = false;
        Play(0.5);

        _viewer.position = new Vector3(3, 1, 0);
        _cell.Frame(_session);

        var away = _words.transform.position - _viewer.position;
        away.y = 0;
        Assert.That(Vector3.Angle(_words.transform.forward, away), Is.LessThan(0.1f));
        Assert.That(_words.transform.up.y, Is.EqualTo(1).Within(1e-5));
        // Height of a capital letter of the built-in font.
        var height = 0.688 * 6.4 * _words.transform.lossyScale.y;
        Assert.That(2 * Math.Atan(height / 2 / Math.Sqrt(10)) * 180 / Math.PI, Is.InRange(0.5, 0.76));
    }

    [Test]
    public void OnDisable_WhileFaint_RestoresTheRenderers()
    {
        _cell.IsPlantUp = false;
        Play(1);

        _appearance.enabled = false;

        Assert.That(_tool.isVisible, Is.True);
        Assert.That(Look(_tool), Is.EqualTo((0f, 0f)));
        Assert.That(_words.text, Is.Empty);
    }

    [Test]
    public void OnDisable_UsersOwnLook_IsRestored()
    {
        var block = new MaterialPropertyBlock();
        block.SetFloat("_Fade", 0.25f);
        block.SetFloat("_Hatch", 1);
        _tool.SetPropertyBlock(block);
        var hidden = Child("Hidden", _rig.transform).AddComponent<MeshRenderer>();
        hidden.forceRenderingOff = true;
        var material = new Material((Shader)null);
        material.SetFloat("_Fade", 0.75f);
        material.SetFloat("_Hatch", 0);
        hidden.sharedMaterial = material;
        BeCurrent();
        var current = (Look(_tool), hidden.forceRenderingOff);
        _cell.IsPlantUp = false;
        Run(1);
        var held = Look(_tool).Fade;

        _appearance.enabled = false;

        Assert.That(current, Is.EqualTo(((0.25f, 1f), true)), "a current pose looks as the user wants it");
        Assert.That(held, Is.EqualTo(0.5f));
        Assert.That(Look(_tool), Is.EqualTo((0.25f, 1f)));
        Assert.That(hidden.forceRenderingOff, Is.True);
        Assert.That(Look(hidden).Fade, Is.EqualTo(0.75f));
    }

    [Test]
    public void Refresh_RendererMovedAway_IsRestored()
    {
        _cell.IsPlantUp = false;
        Play(0.5);
        Assert.That(_tool.isVisible, Is.False);

        _tool.transform.SetParent(null);
        _appearance.Refresh();

        Assert.That(_tool.isVisible, Is.True);
        Assert.That(Look(_tool), Is.EqualTo((0f, 0f)));
    }

    [Test]
    public void OnEnable_Again_LooksLikeThePose()
    {
        BeCurrent();
        _cell.IsPlantUp = false;
        _appearance.enabled = false;
        Run(1);

        _appearance.enabled = true;
        var words = _words.text;

        Assert.That(words, Is.EqualTo("held"), "before the next frame");
    }

    [Test]
    public void Show_ChangingStates_AllocatesNothing()
    {
        // Changes too short for a console message each time.
        _eachFrame = frame => _cell.IsPlantUp = frame % 40 < 12;
        Play(40);
        var changes = _words.TextChanges;

        var allocated = _cell.AllocatedIn(() => Run(40));

        Assert.That(_words.TextChanges - changes, Is.GreaterThan(50));
        Assert.That(allocated, Is.EqualTo(0));
    }

    static int Listeners(object source, string name) =>
        ((Delegate)source.GetType().GetField(name, BindingFlags.Instance | BindingFlags.NonPublic).GetValue(source))?.GetInvocationList().Length ?? 0;

    [Test]
    public void OnDisable_AtAnyFrame_RemovesItsListeners([Values(0, 1, 2, 300)] int frames, [Values] bool destroyed)
    {
        int[] Count() => [Listeners(_session, "Shown"), Listeners(_session, "Hidden"), Listeners(_rig, "Bound")];
        _appearance.enabled = false;
        Play(0);
        for (var i = 0; i < frames; i++) _cell.Frame(_session);
        var before = Count();
        _appearance.enabled = true;
        var during = Count();
        for (var i = 0; i < frames; i++) _cell.Frame(_session);

        if (destroyed) UnityEngine.Object.Destroy(_appearance);
        else _appearance.enabled = false;
        _cell.Frame(_session);

        Assert.That(during, Is.EqualTo(before.Select(count => count + 1)));
        Assert.That(Count(), Is.EqualTo(before));
    }

    [Test]
    public void OnDestroy_AtAnyFrame_DoesNotThrowLater([Values(0, 1, 2, 300)] int frames, [Values] bool words)
    {
        Play(0);
        for (var i = 0; i < frames; i++) _cell.Frame(_session);

        UnityEngine.Object.Destroy(words ? _words.gameObject : _appearance);
        Run(1);
        _cell.Player.Pause(true);
        _cell.Player.Pause(false);
        _cell.IsPlantUp = false;
        Run(1);

        Assert.That(_cell.Player.Logs.Where(l => l.Exception != null), Is.Empty);
    }
}
