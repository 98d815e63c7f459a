using Nowpose.Unity.Tests.Engine.Scripts;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Nowpose.Unity.Tests.Engine.Objects;

public sealed class InstantiateTests : PlayerFixture
{
    [Test]
    public void Instantiate_References_InnerPointToTheCopyAndOuterAreKept()
    {
        var outside = new GameObject("outside").transform;
        var source = Add<Keeper>("a");
        var child = new GameObject("c").transform;
        child.SetParent(source.transform);
        source.target = child;
        source.item = new Keeper.Item { place = outside };
        source.items = [new Keeper.Item { place = source.transform }];

        var copy = Object.Instantiate(source);

        Assert.That(copy.target, Is.SameAs(copy.transform.GetChild(0)));
        Assert.That(copy.item.place, Is.SameAs(outside));
        Assert.That(copy.items[0].place, Is.SameAs(copy.transform));
    }

    [Test]
    public void Instantiate_Fields_SerialisedAreCopiedAndOthersHaveDefaults()
    {
        var source = Add<Keeper>("a");
        source.number = 10;
        source.item = new Keeper.Item { text = "x", forgotten = 70 };
        source.points = [Vector3.one];
        source.Hidden = new Pose(Vector3.one, Quaternion.identity);
        source.unsaved = 30;
        source.State = 50;
        source.table = [];

        var copy = Object.Instantiate(source);
        source.item.text = "y";
        source.points[0] = Vector3.zero;

        Assert.That((copy.number, copy.item.text, copy.points[0], copy.Hidden), Is.EqualTo((10, "x", Vector3.one, source.Hidden)));
        Assert.That((copy.unsaved, copy.item.forgotten, copy.State, copy.fixedOnce), Is.EqualTo((3, 7, 5, 4)));
        Assert.That(copy.table, Is.Null);
    }

    [Test]
    public void Instantiate_NullFields_BecomeEmpty()
    {
        var copy = Object.Instantiate(Add<Keeper>("a"));

        Assert.That((copy.words, copy.item.text, copy.items.Length, copy.points.Count), Is.EqualTo(("", "new", 0, 0)));
        Assert.That(copy.happened.GetPersistentEventCount(), Is.Zero);
        Assert.That(copy.target == null);
    }

    [Test]
    public void Instantiate_SerialisationCallbacks_AreCalledOnSourceAndCopy()
    {
        var source = Add<Keeper>("a");

        var copy = Object.Instantiate(source);

        Assert.That((source.Callbacks, copy.Callbacks), Is.EqualTo(("before ", "after ")));
    }

    [Test]
    public void Instantiate_WithParent_CallsAwakeInTheSceneOfTheParent()
    {
        var parent = new GameObject("p").transform;
        var source = Add<Recorder>("a");
        source.gameObject.layer = 3;
        Journal.Take();

        var copy = Object.Instantiate(source.gameObject, parent);

        Assert.That(Journal.Take(), Is.EqualTo("a(Clone).Awake a(Clone).OnEnable"));
        Assert.That((copy.transform.parent, copy.layer, copy.scene), Is.EqualTo((parent, 3, source.gameObject.scene)));
    }

    [Test]
    public void Instantiate_WithAParent_KeepsTheLocalOrTheWorldPose()
    {
        var parent = new GameObject("p").transform;
        parent.position = new Vector3(5, 0, 0);
        var source = new GameObject("a");
        source.transform.position = Vector3.up;

        Assert.That(Object.Instantiate(source, parent).transform.position, Is.EqualTo(new Vector3(5, 1, 0)));
        Assert.That(Object.Instantiate(source, parent, true).transform.position, Is.EqualTo(Vector3.up));
    }

    [Test]
    public void Instantiate_InactiveOrDisabledObject_KeepsTheState()
    {
        var source = Add<Recorder>("a");
        source.enabled = false;
        source.gameObject.SetActive(false);
        Journal.Take();

        var copy = Object.Instantiate(source);

        Assert.That((copy.enabled, copy.gameObject.activeSelf), Is.EqualTo((false, false)));
        Assert.That(Journal.Take(), Is.Empty);
    }

    [Test]
    public void Instantiate_Hierarchy_PlacesTheChildrenRelativeToTheCopy()
    {
        var source = new GameObject("a").transform;
        source.position = Vector3.right;
        var child = new GameObject("c").transform;
        child.SetParent(source);
        child.localPosition = Vector3.up;
        child.localRotation = Quaternion.Euler(0, 90, 0);
        child.localScale = new Vector3(1, 2, 3);

        var copy = Object.Instantiate(source).GetChild(0);

        Assert.That((copy.name, copy.position, copy.localScale), Is.EqualTo(("c", new Vector3(1, 1, 0), new Vector3(1, 2, 3))));
        Assert.That(copy.rotation, Is.EqualTo(child.rotation));
    }

    [Test]
    public void Instantiate_Asset_IsAnIndependentObject()
    {
        var source = ScriptableObject.CreateInstance<RecordingAsset>();
        source.Number = 9;
        Journal.Take();

        var copy = Object.Instantiate(source);

        Assert.That((copy.Number, Journal.Take()), Is.EqualTo((9, "Awake OnEnable")));
        Assert.That(copy, Is.Not.SameAs(source));
    }

    [Test]
    public void Instantiate_Null_IsRefused() => Assert.That(() => Object.Instantiate<GameObject>(null), Throws.ArgumentException);
}
