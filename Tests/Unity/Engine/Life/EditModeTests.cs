using Nowpose.Unity.Tests.Engine.Scripts;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Life;

/// <summary>Tests objects without a player, as in Unity's edit mode.</summary>
public sealed class EditModeTests
{
    GameObject _object;

    [SetUp]
    public void MakeObject()
    {
        Journal.Take();
        _object = new GameObject("a");
    }

    [TearDown]
    public void DestroyObject() => UnityEngine.Object.DestroyImmediate(_object);

    [Test]
    public void Script_InEditMode_ReceivesNoMessages()
    {
        var a = _object.AddComponent<Recorder>();
        a.enabled = false;
        a.enabled = true;
        _object.SetActive(false);
        _object.SetActive(true);
        UnityEngine.Object.DestroyImmediate(a);

        Assert.That(Journal.Take(), Is.Empty);
        Assert.That(Application.isPlaying, Is.False);
    }

    [Test]
    public void Script_ExecuteAlways_ReceivesAwakeAndOnEnable()
    {
        var a = _object.AddComponent<EditModeRecorder>();
        UnityEngine.Object.DestroyImmediate(a);

        Assert.That(Journal.Take(), Is.EqualTo("a.Awake a.OnEnable a.OnDisable a.OnDestroy"));
    }

    [Test]
    public void Destroy_InEditMode_IsRefused()
    {
        UnityEngine.Object.Destroy(_object);

        Assert.That(_object != null);
    }

    [Test]
    public void Player_Created_DoesNotChangeTheEditorsState()
    {
        var before = Time.frameCount;
        using (var player = new Nowpose.UnityPlayer.Player())
        {
            player.Step(5);
            Assert.That(Application.isPlaying);
            Assert.That(UnityEngine.Object.FindObjectsOfType<Transform>(), Is.Empty);
        }

        Assert.That((Application.isPlaying, Time.frameCount), Is.EqualTo((false, before)));
        Assert.That(UnityEngine.Object.FindObjectsOfType<Transform>(), Does.Contain(_object.transform));
    }
}
