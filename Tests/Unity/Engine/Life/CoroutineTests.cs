using System.Collections;
using Nowpose.Unity.Tests.Engine.Scripts;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Life;

public sealed class CoroutineTests : PlayerFixture
{
    Recorder _owner;

    [SetUp]
    public void MakeOwner()
    {
        _owner = Add<Recorder>("a");
        Frame();
    }

    [Test]
    public void YieldNull_InTheNextFrame_ContinuesAfterTheUpdates()
    {
        _owner.StartCoroutine(Count(3, null));

        Assert.That(Journal.Take(), Is.EqualTo("0"));
        Assert.That(Frame(), Is.EqualTo("a.Update 1 a.LateUpdate"));
        Assert.That(Frame(), Is.EqualTo("a.Update 2 a.LateUpdate"));
        Assert.That(Frame(), Is.EqualTo("a.Update end a.LateUpdate"));
        Assert.That(Frame(), Is.EqualTo("a.Update a.LateUpdate"));
    }

    [Test]
    public void YieldNull_StartedInUpdate_WaitsForTheNextFrame()
    {
        _owner.On["Update"] = () =>
        {
            _owner.On.Clear();
            _owner.StartCoroutine(Count(1, null));
        };

        Assert.That(Frame(), Is.EqualTo("a.Update 0 a.LateUpdate"));
        Assert.That(Frame(), Is.EqualTo("a.Update end a.LateUpdate"));
    }

    [Test]
    public void WaitForEndOfFrame_InTheSameFrame_ContinuesAfterTheLateUpdates()
    {
        _owner.On["Update"] = () =>
        {
            _owner.On.Clear();
            _owner.StartCoroutine(Count(1, new WaitForEndOfFrame()));
        };

        Assert.That(Frame(), Is.EqualTo("a.Update 0 a.LateUpdate end"));
    }

    [Test]
    public void NestedCoroutine_Yielded_RunsBeforeTheOuterContinues()
    {
        _owner.StartCoroutine(Outer());

        Assert.That(Journal.Take(), Is.EqualTo("0"));
        Assert.That(Frame(), Is.EqualTo("a.Update end a.LateUpdate"));
        Assert.That(Frame(), Is.EqualTo("a.Update outer a.LateUpdate"));

        static IEnumerator Outer()
        {
            yield return Count(1, null);
            Journal.Note("outer");
        }
    }

    [Test]
    public void StopCoroutine_Running_EndsIt()
    {
        var routine = _owner.StartCoroutine(Count(9, null));
        _owner.StopCoroutine(routine);
        Journal.Take();

        Assert.That(Frame(2), Does.Not.Contain("1"));
        Assert.That(Player.World.Coroutines.Count, Is.Zero);
    }

    [Test]
    public void Script_Disabled_ContinuesItsCoroutines()
    {
        _owner.StartCoroutine(Count(9, null));
        _owner.enabled = false;
        Journal.Take();

        Assert.That(Frame(), Is.EqualTo("1"));
    }

    [Test]
    public void GameObject_Deactivated_EndsItsCoroutines()
    {
        _owner.StartCoroutine(Count(9, null));
        _owner.gameObject.SetActive(false);
        _owner.gameObject.SetActive(true);
        Journal.Take();

        Assert.That(Frame(2), Does.Not.Contain("1"));
    }

    [Test]
    public void Script_Destroyed_EndsItsCoroutines()
    {
        _owner.StartCoroutine(Count(9, null));
        UnityEngine.Object.Destroy(_owner);
        Frame();

        Assert.That(Frame(2), Is.Empty);
        Assert.That(Player.World.Coroutines.Count, Is.Zero);
    }

    [Test]
    public void StartCoroutine_OnAnInactiveObject_IsAnError()
    {
        _owner.gameObject.SetActive(false);

        Assert.That(_owner.StartCoroutine(Count(1, null)), Is.Null);
        Assert.That(Player.Logs.Single().Type, Is.EqualTo(LogType.Error));
    }

    [Test]
    public void Coroutine_Throws_IsLoggedAndEnds()
    {
        _owner.StartCoroutine(Throwing());
        Frame(3);

        Assert.That(Player.Logs.Single().Message, Is.EqualTo("InvalidOperationException: in routine"));

        static IEnumerator Throwing()
        {
            yield return null;
            throw new InvalidOperationException("in routine");
        }
    }

    static IEnumerator Count(int times, object wait)
    {
        for (var i = 0; i < times; i++)
        {
            Journal.Note($"{i}");
            yield return wait;
        }

        Journal.Note("end");
    }
}
