using Nowpose.Unity.Tests.Engine.Scripts;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Life;

public sealed class LifeCycleTests : PlayerFixture
{
    [Test]
    public void AddComponent_ToAnActiveObject_CallsAwakeAndOnEnableImmediately()
    {
        Add<Recorder>("a");

        Assert.That(Journal.Take(), Is.EqualTo("a.Awake a.OnEnable"));
        Assert.That(Frame(), Is.EqualTo("a.Start a.Update a.LateUpdate"));
        Assert.That(Frame(), Is.EqualTo("a.Update a.LateUpdate"));
    }

    [Test]
    public void SetParent_OtherParent_ReportsTheChangeToTheObjectAndItsDescendants()
    {
        var (moved, child) = (Add<ParentRecorder>("moved"), Add<ParentRecorder>("child"));
        child.transform.SetParent(moved.transform);
        child.enabled = false;
        var parent = new GameObject("parent").transform;
        Journal.Take();

        moved.transform.SetParent(parent);
        moved.transform.SetParent(parent);

        Assert.That(Journal.Take(), Is.EqualTo("moved.OnTransformParentChanged child.OnTransformParentChanged"));
    }

    [Test]
    public void AddComponent_ToAnInactiveObject_CallsAwakeOnlyWhenActive()
    {
        var a = new GameObject("a");
        a.SetActive(false);
        a.AddComponent<Recorder>();

        Assert.That(Frame(), Is.Empty);
        a.SetActive(true);
        Assert.That(Journal.Take(), Is.EqualTo("a.Awake a.OnEnable"));
    }

    [Test]
    public void SetActive_OffAndOn_CallsAwakeAndStartOnce()
    {
        var a = Add<Recorder>("a");
        Frame();

        a.gameObject.SetActive(false);
        Assert.That(Journal.Take(), Is.EqualTo("a.OnDisable"));
        Assert.That(Frame(), Is.Empty);
        a.gameObject.SetActive(true);
        Assert.That(Journal.Take(), Is.EqualTo("a.OnEnable"));
        Assert.That(Frame(), Is.EqualTo("a.Update a.LateUpdate"));
    }

    [Test]
    public void Enabled_FalseThenTrue_PausesFrameMessages()
    {
        var a = Add<Recorder>("a");
        Frame();

        a.enabled = false;
        a.enabled = false;

        Assert.That(Journal.Take(), Is.EqualTo("a.OnDisable"));
        Assert.That(Frame(), Is.Empty);
        Assert.That(a.isActiveAndEnabled, Is.False);
        a.enabled = true;
        Assert.That(Journal.Take() + " " + Frame(), Is.EqualTo("a.OnEnable a.Update a.LateUpdate"));
    }

    [Test]
    public void Enabled_FalseBeforeTheFirstFrame_DelaysStart()
    {
        var a = Add<Recorder>("a");
        a.enabled = false;
        Journal.Take();

        Assert.That(Frame(), Is.Empty);
        a.enabled = true;
        Assert.That(Frame(), Is.EqualTo("a.OnEnable a.Start a.Update a.LateUpdate"));
    }

    [Test]
    public void Awake_DisablesItself_IsNotEnabled()
    {
        var holder = new GameObject("a");
        holder.SetActive(false);
        var a = holder.AddComponent<Recorder>();
        a.On["Awake"] = () => a.enabled = false;

        holder.SetActive(true);

        Assert.That(Journal.Take(), Is.EqualTo("a.Awake"));
        Assert.That(Frame(), Is.Empty);
    }

    [Test]
    public void Awake_DeactivatesItsObject_EnablesNothingBelow()
    {
        var holder = new GameObject("a");
        holder.SetActive(false);
        var a = holder.AddComponent<Recorder>();
        Add<Recorder>("b", holder.transform);
        a.On["Awake"] = () => holder.SetActive(false);
        Journal.Take();

        holder.SetActive(true);

        Assert.That(Journal.Take(), Is.EqualTo("a.Awake"));
        Assert.That(holder.activeInHierarchy, Is.False);
    }

    [Test]
    public void Parent_Inactive_KeepsAnActiveChildInactive()
    {
        var parent = new GameObject("p");
        parent.SetActive(false);
        var child = new GameObject("c");
        child.transform.SetParent(parent.transform);
        child.AddComponent<Recorder>();

        Assert.That((child.activeSelf, child.activeInHierarchy), Is.EqualTo((true, false)));
        child.SetActive(false);
        child.SetActive(true);
        Assert.That(Journal.Take(), Is.Empty);
        parent.SetActive(true);
        Assert.That(Journal.Take(), Is.EqualTo("c.Awake c.OnEnable"));
    }

    [Test]
    public void SetParent_UnderAnInactiveObjectAndBack_DisablesAndEnables()
    {
        var parent = new GameObject("p");
        parent.SetActive(false);
        var child = Add<Recorder>("c");
        Journal.Take();

        child.transform.SetParent(parent.transform);
        Assert.That(Journal.Take(), Is.EqualTo("c.OnDisable"));
        child.transform.SetParent(null);
        Assert.That(Journal.Take(), Is.EqualTo("c.OnEnable"));
    }

    [Test]
    public void SetActive_False_DisablesChildrenFirst()
    {
        var p = Add<Recorder>("p");
        Add<Recorder>("c", p.transform);
        Journal.Take();

        p.gameObject.SetActive(false);

        Assert.That(Journal.Take(), Is.EqualTo("c.OnDisable p.OnDisable"));
    }

    [Test]
    public void OnDisable_ObjectDeactivated_SeesTheObjectInactive()
    {
        var a = Add<Recorder>("a");
        var active = true;
        a.On["OnDisable"] = () => active = a.gameObject.activeInHierarchy;

        a.gameObject.SetActive(false);

        Assert.That(active, Is.False);
    }

    [Test]
    public void Update_AddsAScript_StartsAndLateUpdatesItInTheSameFrame()
    {
        var a = Add<Recorder>("a");
        Frame();
        a.On["Update"] = () =>
        {
            a.On.Remove("Update");
            Add<Recorder>("b");
        };

        Assert.That(Frame(), Is.EqualTo("a.Update b.Awake b.OnEnable b.Start a.LateUpdate b.LateUpdate"));
        Assert.That(Frame(), Is.EqualTo("a.Update b.Update a.LateUpdate b.LateUpdate"));
    }

    [Test]
    public void Update_DisablesTheNextScript_SkipsIt()
    {
        var a = Add<Recorder>("a");
        var b = Add<Recorder>("b");
        Frame();
        a.On["Update"] = () => b.enabled = false;

        Assert.That(Frame(), Is.EqualTo("a.Update b.OnDisable a.LateUpdate"));
    }

    [Test]
    public void Update_DisablesThePreviousScript_CallsAllOtherScriptsOnce()
    {
        var a = Add<Recorder>("a");
        var b = Add<Recorder>("b");
        Add<Recorder>("c");
        Frame();
        b.On["Update"] = () => a.enabled = false;

        Assert.That(Frame(), Is.EqualTo("a.Update b.Update a.OnDisable c.Update b.LateUpdate c.LateUpdate"));
        Assert.That(Frame(), Is.EqualTo("b.Update c.Update b.LateUpdate c.LateUpdate"));
    }

    [Test]
    public void Start_DisablesItself_ReceivesNoUpdate()
    {
        var a = Add<Recorder>("a");
        Journal.Take();
        a.On["Start"] = () => a.enabled = false;

        Assert.That(Frame(), Is.EqualTo("a.Start a.OnDisable"));
    }

    [Test]
    public void Start_AddsAComponent_StartsItBeforeItsFirstUpdate()
    {
        var a = Add<Recorder>("a");
        Journal.Take();
        a.On["Start"] = () => Add<Recorder>("b");

        Assert.That(Frame(), Is.EqualTo("a.Start b.Awake b.OnEnable a.Update b.Start b.Update a.LateUpdate b.LateUpdate"));
    }

    [Test]
    public void Start_AddsAComponentThatDisablesItself_SkipsItsUpdate()
    {
        var a = Add<Recorder>("a");
        Journal.Take();
        a.On["Start"] = () =>
        {
            var b = Add<Recorder>("b");
            b.On["Start"] = () => b.enabled = false;
        };

        Assert.That(Frame(), Is.EqualTo("a.Start b.Awake b.OnEnable a.Update b.Start b.OnDisable a.LateUpdate"));
    }

    [Test]
    public void Start_WithoutFrameMessages_IsCalledInTheFirstFrame()
    {
        Add<Starter>("a");

        Assert.That(Frame(), Is.EqualTo("a.Start"));
        Assert.That(Frame(), Is.Empty);
    }

    [Test]
    public void Message_PrivateInABaseClass_IsCalled()
    {
        Add<Derived>("a");

        Assert.That(Frame(), Is.EqualTo("base.Update"));
    }

    [Test]
    public void Message_NotCalledByTheStandIn_IsRefused() =>
        Assert.That(() => Add<WithFixedUpdate>("a"), Throws.TypeOf<NotSupportedException>().With.Message.Contains("WithFixedUpdate.FixedUpdate"));
}
