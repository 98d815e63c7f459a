using Nowpose.Unity.Tests.Engine.Scripts;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Tests.Engine.Objects;

public sealed class ComponentTests : PlayerFixture
{
    [Test]
    public void AddComponent_WithRequirements_AddsThemFirst()
    {
        var a = new GameObject("a");
        var mesh = a.AddComponent<MeshRenderer>();
        a.AddComponent<Demanding>();

        Assert.That(a.GetComponents<Component>().Select(c => c.GetType().Name),
            Is.EqualTo(new[] { "Transform", "MeshRenderer", "TextMesh", "Demanding" }));
        Assert.That(a.GetComponent<Renderer>(), Is.SameAs(mesh));
    }

    [Test]
    public void AddComponent_SecondWithDisallowMultipleComponent_IsRefused()
    {
        var a = new GameObject("a");
        a.AddComponent<Demanding>();

        Assert.That(a.AddComponent<Demanding>(), Is.Null);
        Assert.That(Player.Logs.Single().Type, Is.EqualTo(LogType.Error));
    }

    [Test]
    public void GetComponent_InterfaceOrBase_FindsTheFirstComponent()
    {
        var a = Add<Keeper>("a");

        Assert.That(a.GetComponent<ISerializationCallbackReceiver>(), Is.SameAs(a));
        Assert.That(a.GetComponent<MonoBehaviour>(), Is.SameAs(a));
        Assert.That(a.TryGetComponent<Camera>(out var none), Is.False);
        Assert.That(none, Is.Null);
    }

    [Test]
    public void GetComponents_BelowAndAbove_SkipInactiveUnlessRequested()
    {
        var top = Add<Recorder>("top");
        var off = Add<Recorder>("off", top.transform);
        var leaf = Add<Recorder>("leaf", off.transform);
        off.gameObject.SetActive(false);

        Assert.That(top.GetComponentsInChildren<Recorder>(), Is.EqualTo(new[] { top }));
        Assert.That(top.GetComponentsInChildren<Recorder>(true), Is.EqualTo(new[] { top, off, leaf }));
        Assert.That(leaf.GetComponentInParent<Recorder>(), Is.SameAs(top));
        Assert.That(leaf.GetComponentsInParent<Recorder>(true), Is.EqualTo(new[] { leaf, off, top }));
        Assert.That(off.GetComponentInChildren<Recorder>() == null);
    }

    [Test]
    public void FindObjectsOfType_ActiveObjects_ReturnsThemInHierarchyOrder()
    {
        var a = Add<Recorder>("a");
        var b = Add<EarlyRecorder>("b");
        var c = Add<Recorder>("c", a.transform);
        var off = Add<Recorder>("off");
        off.gameObject.SetActive(false);
        off.enabled = false;

        Assert.That(Object.FindObjectsOfType<Recorder>(), Is.EqualTo(new Recorder[] { a, c, b }));
        Assert.That(Object.FindObjectOfType<EarlyRecorder>(), Is.SameAs(b));
        Assert.That(Object.FindObjectsOfType<Recorder>(true), Has.Length.EqualTo(4));
        Assert.That(Player.Find<EarlyRecorder>(), Is.SameAs(b));
        Assert.That(Object.FindObjectOfType<Camera>() == null);
    }

    [Test]
    public void GameObjectFind_NameOrPath_FindsOnlyActiveObjects()
    {
        var a = new GameObject("a");
        var b = new GameObject("b");
        b.transform.SetParent(a.transform);

        Assert.That(GameObject.Find("b"), Is.SameAs(b));
        Assert.That(GameObject.Find("/a/b"), Is.SameAs(b));
        a.SetActive(false);
        Assert.That(GameObject.Find("b"), Is.Null);
    }

    [Test]
    public void GetComponents_ListOfSufficientCapacity_AllocateNothing()
    {
        var top = Add<Recorder>("top");
        Add<Recorder>("leaf", top.transform);
        var list = new List<Recorder>();
        top.GetComponentsInChildren(list);
        top.GetComponent<Recorder>();
        top.TryGetComponent<Camera>(out _);

        var before = GC.GetAllocatedBytesForCurrentThread();
        top.GetComponentsInChildren(list);
        top.GetComponent<Recorder>();
        top.TryGetComponent<Camera>(out _);

        Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
    }
}
