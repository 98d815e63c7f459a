using Nowpose.Latency;
using Nowpose.Session;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Rendering;

/// <summary>Tests the look of the parts in each state of the pose.</summary>
public class PoseAppearanceTests
{
    PlayedAppearance _played;

    [SetUp]
    public void Begin() => _played = new PlayedAppearance();

    [TearDown]
    public void End() => _played.Dispose();

    void Take(double ms)
    {
        for (var i = 0; i < 20; i++) _played.Session.Session.Rendered(TimeSpan.FromMilliseconds(ms), RenderTimeSourceKind.DisplayGpuTime);
    }

    [Test]
    public void Show_Current_IsDrawnUnchangedWithoutText()
    {
        _played.BeCurrent();

        Assert.That(_played.Tool.isVisible, Is.True);
        Assert.That(_played.Look(_played.Tool), Is.EqualTo((0f, 0f)));
        Assert.That(_played.Label.text, Is.Empty);
    }

    [Test]
    public void Show_TextActivatedWhileNotCurrent_KeepsTheTextureOfItsFont()
    {
        var font = new Material((Shader)null) { mainTexture = new Texture2D(256, 256) };
        var text = PlayedAppearance.Child("Text", _played.Rig.transform);
        text.SetActive(false);
        var renderer = text.AddComponent<MeshRenderer>();
        renderer.sharedMaterial = UserMaterials.Blended("_Color", 0.8f);
        text.AddComponent<TextMesh>();
        text.AddComponent<FontTexture>().With("_fontMaterial", font);
        _played.BeCurrent();
        _played.Cell.IsPlantUp = false;
        _played.Run(1);
        var block = new MaterialPropertyBlock();
        renderer.GetPropertyBlock(block);
        Assert.That(block.GetColor("_Color").a, Is.LessThan(0.8f), "not current");

        text.SetActive(true);
        _played.Cell.IsPlantUp = true;
        _played.Run(1);

        renderer.GetPropertyBlock(block);
        Assert.That((block.GetColor("_Color").a, block.GetTexture("_MainTex")), Is.EqualTo((0.8f, font.mainTexture)));
    }

    [Test]
    public void Show_BeforeTheFirstPositions_DrawsOnlyTheText()
    {
        _played.Cell.IsPlantUp = false;
        var wasVisible = new List<bool>();
        _played.EachFrame = _ => wasVisible.Add(_played.Tool.isVisible);

        _played.Play(2);

        Assert.That(wasVisible, Is.Not.Empty.And.All.False, "not in the first frame either");
        Assert.That(_played.Label.text, Is.EqualTo(PoseMessages.Of(PoseState.Incomplete)));
        Assert.That(_played.Label.GetComponent<Renderer>().isVisible, Is.True);
    }

    [Test]
    public void Show_NotSynchronised_IsFaintStripedWithText()
    {
        _played.Cell.IsSyncUp = false;

        _played.Play(2);

        Assert.That(_played.Tool.isVisible, Is.True);
        Assert.That(_played.Look(_played.Tool).Fade, Is.GreaterThan(0.5));
        Assert.That(_played.Look(_played.Tool).Hatch, Is.EqualTo(1));
        Assert.That(_played.Label.text, Is.EqualTo(PoseMessages.Of(PoseState.Unsynchronised)));
    }

    [Test]
    public void Show_SamplesStop_IsFaintStripedWithTextUntilTheyReturn()
    {
        _played.BeCurrent();

        _played.Cell.IsPlantUp = false;
        _played.Run(1);
        var (held, words) = (_played.Look(_played.Tool), _played.Label.text);
        _played.Cell.IsPlantUp = true;
        _played.Run(1);

        Assert.That(held.Fade, Is.GreaterThan(0.2));
        Assert.That(held.Hatch, Is.EqualTo(1));
        Assert.That(words, Is.EqualTo("held"));
        Assert.That(_played.Look(_played.Tool), Is.EqualTo((0f, 0f)));
        Assert.That(_played.Label.text, Is.Empty);
    }

    [Test]
    public void Show_OutsideRange_IsFaintStripedWithText()
    {
        _played.BeCurrent();

        Take(30);
        _played.Cell.Frame(_played.Session);

        Assert.That(_played.Look(_played.Tool).Fade, Is.GreaterThan(0.2));
        Assert.That(_played.Look(_played.Tool).Hatch, Is.EqualTo(1));
        Assert.That(_played.Label.text, Is.EqualTo(PoseMessages.Of(PoseState.OutsideRange)));
    }

    [Test]
    public void Hidden_SessionPaused_IsDrawnAsNotCurrent()
    {
        _played.BeCurrent();

        _played.Cell.Player.Pause(true);
        var paused = (_played.Look(_played.Tool), _played.Label.text, _played.Tool.isVisible);
        _played.Cell.Player.Pause(false);
        _played.Cell.Frame(_played.Session);
        var resumed = _played.Label.text;
        _played.Run(5);

        Assert.That(paused.Item1.Hatch, Is.EqualTo(1), "the stripes appear before the next frame");
        Assert.That(paused.text, Is.EqualTo(StatusMessages.NoSession));
        Assert.That(paused.isVisible, Is.True);
        Assert.That(resumed, Is.EqualTo(PoseMessages.Of(PoseState.Incomplete)).Or.EqualTo(PoseMessages.Of(PoseState.Unsynchronised)));
        Assert.That(_played.Look(_played.Tool), Is.EqualTo((0f, 0f)));
    }

    [Test]
    public void Hidden_BeforeTheFirstPositions_IsNotDrawn()
    {
        _played.Cell.IsPlantUp = false;
        _played.Play(0.5);

        _played.Session.enabled = false;
        _played.Cell.Frame(_played.Session);

        Assert.That(_played.Tool.isVisible, Is.False);
    }

    [Test]
    public void Show_Ghost_HasALabelInEachState()
    {
        _played.Rig.With("_shows", RigPose.Held);
        _played.BeCurrent();
        var current = (_played.Look(_played.Tool), _played.Label.text);

        _played.Cell.IsPlantUp = false;
        _played.Run(1);

        Assert.That(current, Is.EqualTo(((0f, 0f), "uncompensated")));
        Assert.That(_played.Label.text, Is.EqualTo("uncompensated, held"));
    }

    [Test]
    public void Show_UserPropertyBlock_KeepsItsProperties()
    {
        var block = new MaterialPropertyBlock();
        block.SetFloat("_Own", 7);
        _played.Tool.SetPropertyBlock(block);

        _played.BeCurrent();

        _played.Tool.GetPropertyBlock(block);
        Assert.That(block.GetFloat("_Own"), Is.EqualTo(7));
    }

    [Test]
    public void Show_RendererDisabledByTheUser_StaysDisabled()
    {
        _played.Tool.enabled = false;

        _played.BeCurrent();

        Assert.That(_played.Tool.enabled, Is.False);
        Assert.That(_played.Tool.isVisible, Is.False);
    }

    [Test]
    public void LateUpdate_Text_FacesTheViewerAndIsLegible()
    {
        _played.Cell.IsPlantUp = false;
        _played.Play(0.5);

        _played.Viewer.position = new Vector3(3, 1, 0);
        _played.Cell.Frame(_played.Session);

        var away = _played.Label.transform.position - _played.Viewer.position;
        away.y = 0;
        Assert.That(Vector3.Angle(_played.Label.transform.forward, away), Is.LessThan(0.1f));
        Assert.That(_played.Label.transform.up.y, Is.EqualTo(1).Within(1e-5));
        // Height of a capital letter: 0.688 is its fraction of the font size in the built-in font.
        var height = 0.688 * 6.4 * _played.Label.transform.lossyScale.y;
        Assert.That(2 * Math.Atan(height / 2 / Math.Sqrt(10)) * 180 / Math.PI, Is.InRange(0.5, 0.76));
    }

    // The shift of a calibration by eye changes the look at once; a change of the pose's state is logged, which allocates.
    [Test]
    public void Show_ChangingLooks_AllocatesNothing()
    {
        _played.BeCurrent();
        _played.EachFrame = frame => _played.Rig.Shift = frame % 40 < 12 ? new Vector3(0, 0.001f, 0) : Vector3.zero;
        _played.Run(2);
        var changes = _played.Label.TextChanges;

        var allocated = _played.Cell.AllocatedIn(() => _played.Run(40));

        Assert.That(_played.Label.TextChanges - changes, Is.GreaterThan(50));
        Assert.That(allocated, Is.EqualTo(0));
    }
}
