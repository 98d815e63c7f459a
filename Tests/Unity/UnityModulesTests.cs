using NUnit.Framework;

namespace Nowpose.Unity.Tests;

public sealed class UnityModulesTests
{
    [TestCase("using UnityEngine.XR;", "xr")]
    [TestCase("using UnityEngine; class A { XRDisplaySubsystem _d; }", "xr")]
    [TestCase("using UnityEngine; class A { float _s = UnityEngine.XR.XRSettings.eyeTextureResolutionScale; }", "vr")]
    [TestCase("using UnityEngine.UIElements;", "uielements")]
    [TestCase("using UnityEngine.Networking;", "unitywebrequest")]
    [TestCase("using U = UnityEngine.Networking.UnityWebRequest;", "unitywebrequest")]
    [TestCase("using UnityEngine; class A { AudioSource _a; }", "audio")]
    [TestCase("using UnityEngine; class A { Rigidbody _a; }", "physics")]
    [TestCase("using UnityEngine; [RequireComponent(typeof(BoxCollider))] class A { }", "physics")]
    [TestCase("using UnityEngine; class A { void B() => JsonUtility.ToJson(this); }", "jsonserialize")]
    [TestCase("using UnityEngine; class A { void OnGUI() { } }", "imgui")]
    [TestCase("using UnityEngine; class A { void B() { GUILayout.Label(\"x\"); } }", "imgui")]
    [TestCase("using UnityEditor; class A { object B() => new GUIContent(); }", "imgui")]
    [TestCase("class A { UnityEngine.Animator _a; }", "animation")]
    [TestCase("using UnityEngine; class A { Canvas _a; }", "ui")]
    [TestCase("using UnityEngine; class A { ParticleSystem _a; }", "particlesystem")]
    [TestCase("using UnityEngine; class A { void B(Texture2D t) => t.EncodeToPNG(); }", "imageconversion")]
    [TestCase("using UnityEngine; class A { Terrain _a; }", "terrain")]
    [TestCase("using UnityEngine.Video;", "video")]
    public void UsedByCode_TypeOfAModule_ReturnsTheModule(string source, string module)
    {
        Assert.That(UnityModules.UsedByCode(source), Does.Contain(module));
    }

    [TestCase("using UnityEngine; class A : MonoBehaviour { Transform _t; Camera _c; TextMesh _m; AnimationCurve _a; RectTransform _r; }")]
    [TestCase("using UnityEngine; class A { Vector3 _rigidbodyCentre; MyRigidbody _b; }")]
    [TestCase("using UnityEngine; // a Rigidbody would need UnityEngine.XR\nclass A { string _a = \"AudioSource\"; }")]
    [TestCase("using UnityEngine; /* Canvas\n Animator */ class A { string _a = @\"GUI \"\" Cloth\"; }")]
    [TestCase("using UnityEngine.XR.ARFoundation; class A { }")]
    [TestCase("using UnityEditor; class A { object _a = PlayerSettings.WSACapability.Microphone; }")]
    [TestCase("namespace Nowpose { class Terrain { Event _event; Physics _physics; } }")]
    [TestCase("using System.Text.Json;")]
    public void UsedByCode_CoreTypesOrOwnNames_ReturnsNone(string source)
    {
        Assert.That(UnityModules.UsedByCode(source), Is.Empty);
    }

    [TestCase("--- !u!82 &1\nAudioSource:\n", "audio")]
    [TestCase("--- !u!1 &1\nGameObject:\n--- !u!65 &2\nBoxCollider:\n", "physics")]
    [TestCase("--- !u!223 &1\nCanvas:\n", "ui")]
    public void UsedByAsset_ComponentOfAModule_ReturnsTheModule(string yaml, string module)
    {
        Assert.That(UnityModules.UsedByAsset(yaml), Is.EqualTo(new[] { module }));
    }

    [Test]
    public void UsedByAsset_CoreComponents_ReturnsNone()
    {
        Assert.That(UnityModules.UsedByAsset("--- !u!1 &65\nGameObject:\n--- !u!4 &82\nTransform:\n--- !u!102 &3\nTextMesh:\n"), Is.Empty);
    }
}
