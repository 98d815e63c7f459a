using Nowpose.Unity.Tests.Engine.Scripts;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Life;

public sealed class ExecutionOrderTests : PlayerFixture
{
    [Test]
    public void Scripts_InAFrame_RunByExecutionOrderThenByCreation()
    {
        Add<LateRecorder>("late");
        Add<Recorder>("a");
        Add<EarlyRecorder>("early");
        Add<Recorder>("b");
        Frame();

        Assert.That(Frame(), Is.EqualTo("early.Update a.Update b.Update late.Update early.LateUpdate a.LateUpdate b.LateUpdate late.LateUpdate"));
    }

    [Test]
    public void Script_DisabledAndEnabledAgain_KeepsItsOrder()
    {
        var early = Add<EarlyRecorder>("early");
        Add<Recorder>("a");
        Frame();

        early.enabled = false;
        Frame();
        early.enabled = true;
        Journal.Take();

        Assert.That(Frame(), Is.EqualTo("early.Update a.Update early.LateUpdate a.LateUpdate"));
    }

    [Test]
    public void Scene_Loaded_CallsAwakeByExecutionOrder()
    {
        var root = GameObject.Detached("late");
        root.Add(typeof(LateRecorder));
        var child = GameObject.Detached("early");
        child.Add(typeof(EarlyRecorder));
        child.transform.SetParent(root.transform);
        Assert.That(Journal.Take(), Is.Empty);

        Player.LoadScene([root]);

        Assert.That(Journal.Take(), Is.EqualTo("early.Awake early.OnEnable late.Awake late.OnEnable"));
        Assert.That(Frame(), Does.StartWith("early.Start late.Start early.Update"));
    }
}
