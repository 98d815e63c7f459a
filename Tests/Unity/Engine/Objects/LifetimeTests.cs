using Nowpose.Unity.Tests.Engine.Scripts;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Tests.Engine.Objects;

public sealed class LifetimeTests : PlayerFixture
{
    [Test]
    public void Object_Destroyed_EqualsNullEverywhere()
    {
        var a = Add<Recorder>("a");
        var gameObject = a.gameObject;

        Object.DestroyImmediate(gameObject);

        Assert.That(a == null && gameObject == null && null == a && !a && !(a != null));
        Assert.That(a.Equals(null));
        Assert.That(a is null, Is.False);
        Assert.That(gameObject.ToString(), Is.EqualTo("null"));
    }

    [Test]
    public void TwoObjects_Destroyed_AreEqual()
    {
        var a = new GameObject("a");
        var b = new GameObject("b");
        Object.DestroyImmediate(a);
        Object.DestroyImmediate(b);

        Assert.That(a == b);
    }

    [Test]
    public void Object_NotDestroyed_EqualsOnlyItself()
    {
        var a = new GameObject("a");
        var b = new GameObject("a");

        Assert.That(a != b && a != null && a);
        Assert.That((a == b.transform.gameObject, a == a.transform.gameObject), Is.EqualTo((false, true)));
    }

    [Test]
    public void Members_OfADestroyedObject_Throw()
    {
        var a = Add<Recorder>("a");
        var transform = a.transform;
        Object.DestroyImmediate(a.gameObject);

        Assert.That(() => a.name, Throws.TypeOf<MissingReferenceException>().With.Message.Contains("'Recorder' has been destroyed"));
        Assert.That(() => a.gameObject, Throws.TypeOf<MissingReferenceException>());
        Assert.That(() => a.enabled = false, Throws.TypeOf<MissingReferenceException>());
        Assert.That(() => transform.position, Throws.TypeOf<MissingReferenceException>());
        Assert.That(() => transform.localRotation = Quaternion.identity, Throws.TypeOf<MissingReferenceException>());
        Assert.That(() => transform.SetParent(null), Throws.TypeOf<MissingReferenceException>());
        Assert.That(a.isActiveAndEnabled, Is.False);
    }

    [Test]
    public void Destroy_DuringAFrame_TakesEffectAfterTheUpdates()
    {
        var a = Add<Recorder>("a");
        Frame();
        a.On["Update"] = () =>
        {
            Object.Destroy(a.gameObject);
            Object.Destroy(a.gameObject);
            Assert.That(a != null);
        };

        Assert.That(Frame(), Is.EqualTo("a.Update a.LateUpdate a.OnDisable a.OnDestroy"));
        Assert.That(a == null);
    }

    [Test]
    public void Destroy_Component_KeepsItsObject()
    {
        var a = Add<Recorder>("a");
        var gameObject = a.gameObject;
        Journal.Take();

        Object.DestroyImmediate(a);

        Assert.That(Journal.Take(), Is.EqualTo("a.OnDisable a.OnDestroy"));
        Assert.That(gameObject.GetComponent<Recorder>() == null && gameObject != null);
        Assert.That(Frame(), Is.Empty);
    }

    [Test]
    public void Destroy_Parent_DisablesAllThenDestroysAll()
    {
        var a = Add<Recorder>("a");
        Add<Recorder>("c", a.transform);
        Journal.Take();

        Object.DestroyImmediate(a.gameObject);

        Assert.That(Journal.Take(), Is.EqualTo("c.OnDisable a.OnDisable a.OnDestroy c.OnDestroy"));
    }

    [Test]
    public void Destroy_ObjectNeverActive_SendsNoMessage()
    {
        var a = new GameObject("a");
        a.SetActive(false);
        a.AddComponent<Recorder>();

        Object.DestroyImmediate(a);

        Assert.That(Journal.Take(), Is.Empty);
    }

    [Test]
    public void Destroy_DisabledScriptAfterAwake_SendsOnlyOnDestroy()
    {
        var a = Add<Recorder>("a");
        a.enabled = false;
        Journal.Take();

        Object.DestroyImmediate(a.gameObject);

        Assert.That(Journal.Take(), Is.EqualTo("a.OnDestroy"));
    }

    [Test]
    public void OnDestroy_DestroysItsObjectAgain_HasNoEffect()
    {
        var a = Add<Recorder>("a");
        a.On["OnDestroy"] = () => Object.DestroyImmediate(a.gameObject);

        Object.DestroyImmediate(a.gameObject);

        Assert.That(a == null);
        Assert.That(Player.Logs, Is.Empty);
    }

    [Test]
    public void Destroy_Child_IsRemovedFromItsParentAfterTheFrame()
    {
        var parent = new GameObject("p").transform;
        var child = Add<Recorder>("c", parent);
        Frame();

        Object.Destroy(child.gameObject);
        Frame();

        Assert.That(parent.childCount, Is.Zero);
    }

    [Test]
    public void Destroy_Transform_IsRefused()
    {
        var a = new GameObject("a");

        Object.Destroy(a.transform);
        Frame();

        Assert.That(a.transform != null);
        Assert.That(Player.Logs.Single().Type, Is.EqualTo(LogType.Error));
    }

    [Test]
    public void Destroy_RequiredComponent_IsRefused()
    {
        var a = new GameObject("a").AddComponent<Demanding>();
        var text = a.GetComponent<TextMesh>();

        Object.DestroyImmediate(text);

        Assert.That(text != null);
        Assert.That(Player.Logs.Single().Message, Does.Contain("Can't remove TextMesh because Demanding"));
    }

    [Test]
    public void Destroy_Null_HasNoEffect()
    {
        Object.Destroy(null);
        Object.DestroyImmediate(null);

        Assert.That(Player.Logs, Is.Empty);
    }

    [Test]
    public void Destroy_Asset_IsRefused()
    {
        var mesh = GameObject.CreatePrimitive(PrimitiveType.Cube).GetComponent<MeshFilter>().sharedMesh;

        Object.Destroy(mesh);
        Object.DestroyImmediate(mesh);

        Assert.That(mesh != null);
        Assert.That(Player.Logs.Select(l => l.Message), Is.Not.Empty.And.All.Contains("Destroying assets is not permitted"));
    }

    [Test]
    public void ObjectCount_ObjectsCreatedAndDestroyed_IsUnchanged()
    {
        var before = Player.ObjectCount;

        var made = new GameObject("a", typeof(MeshFilter));
        made.GetComponent<MeshFilter>().sharedMesh = new Mesh();
        Assert.That(Player.ObjectCount, Is.EqualTo(before + 4));
        Object.DestroyImmediate(made.GetComponent<MeshFilter>().sharedMesh);
        Object.DestroyImmediate(made);

        Assert.That(Player.ObjectCount, Is.EqualTo(before));
    }

    [Test]
    public void Name_OfAComponent_IsTheNameOfItsObject()
    {
        var a = Add<Recorder>("a");
        a.name = "b";

        Assert.That(a.gameObject.name, Is.EqualTo("b"));
    }

    [Test]
    public void ScriptableObject_CreatedAndDestroyed_ReceivesOnlyMessagesOfItsCreation()
    {
        var made = ScriptableObject.CreateInstance<RecordingAsset>();
        Assert.That(Journal.Take(), Is.EqualTo("Awake OnEnable"));

        Object.Destroy(made);
        Frame();

        Assert.That(Journal.Take() + (made == null), Is.EqualTo("True"));
    }

    [Test]
    public void ScriptableObject_DestroyedImmediately_ReceivesItsMessages()
    {
        var made = ScriptableObject.CreateInstance<RecordingAsset>();
        Journal.Take();

        Object.DestroyImmediate(made);

        Assert.That(Journal.Take(), Is.EqualTo("OnDisable OnDestroy"));
    }
}
