using Nowpose.Unity.Tests.Engine.Scripts;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Events;
using UnityEngine.Serialization;

namespace Nowpose.Unity.Tests.Engine;

public sealed class UnityEventTests : PlayerFixture
{
    [Test]
    public void Invoke_Listeners_AreCalledInOrderAndNotAfterRemoval()
    {
        var happened = new UnityEvent();
        void First() => Journal.Note("first");
        happened.AddListener(First);
        happened.AddListener(() => Journal.Note("second"));

        happened.Invoke();
        happened.RemoveListener(First);
        happened.Invoke();

        Assert.That(Journal.Take(), Is.EqualTo("first second second"));
    }

    [Test]
    public void Invoke_PersistentCall_RunsBeforeTheListeners()
    {
        var listener = Add<Listener>("a");
        var happened = FromFile<UnityEvent>(listener, "Heard", PersistentListenerMode.Void);
        happened.AddListener(() => Journal.Note("code"));

        happened.Invoke();

        Assert.That(Journal.Take(), Is.EqualTo("Heard code"));
        Assert.That((happened.GetPersistentEventCount(), happened.GetPersistentTarget(0), happened.GetPersistentMethodName(0)),
            Is.EqualTo((1, listener, "Heard")));
    }

    [TestCase("Int", "m_IntArgument", 4, "HeardInt(4)")]
    [TestCase("String", "m_StringArgument", "x", "HeardString(x)")]
    [TestCase("Bool", "m_BoolArgument", true, "HeardBool(True)")]
    public void Invoke_CallWithAStoredArgument_PassesTheArgument(string mode, string field, object value, string expected)
    {
        var happened = FromFile<UnityEvent>(Add<Listener>("a"), "Heard" + mode, Enum.Parse<PersistentListenerMode>(mode), (field, value));

        happened.Invoke();

        Assert.That(Journal.Take(), Is.EqualTo(expected));
    }

    [Test]
    public void Invoke_EventWithAnArgument_PassesItToCallsWithoutAStoredArgument()
    {
        var listener = Add<Listener>("a");
        var passed = FromFile<UnityEvent<int>>(listener, "HeardInt", PersistentListenerMode.EventDefined);
        var kept = FromFile<UnityEvent<int>>(listener, "HeardInt", PersistentListenerMode.Int, ("m_IntArgument", 4));
        var none = FromFile<UnityEvent<int>>(listener, "Heard", PersistentListenerMode.Void);
        passed.AddListener(value => Journal.Note("code " + value));

        passed.Invoke(7);
        kept.Invoke(7);
        none.Invoke(7);

        Assert.That(Journal.Take(), Is.EqualTo("HeardInt(7) code 7 HeardInt(4) Heard"));
    }

    [Test]
    public void Invoke_CallWithAnotherArgumentType_LogsAnErrorWithTheMethod()
    {
        FromFile<UnityEvent<int>>(Add<Listener>("a"), "HeardBool", PersistentListenerMode.EventDefined).Invoke(7);

        Assert.That(Player.Logs.Single().Message, Does.Contain("Listener.HeardBool"));
    }

    [Test]
    public void Invoke_CallDisabledOrWithoutTarget_IsSkipped()
    {
        var listener = Add<Listener>("a");
        var off = FromFile<UnityEvent>(listener, "Heard", PersistentListenerMode.Void);
        Set(off.Persistent.Calls[0], "m_CallState", UnityEventCallState.Off);
        var gone = FromFile<UnityEvent>(listener, "Heard", PersistentListenerMode.Void);
        UnityEngine.Object.DestroyImmediate(listener);

        off.Invoke();
        gone.Invoke();

        Assert.That(Journal.Take(), Is.Empty);
    }

    [Test]
    public void Invoke_CallOfAMissingMethod_LogsAnErrorWithTheMethod()
    {
        FromFile<UnityEvent>(Add<Listener>("a"), "Nowhere", PersistentListenerMode.Void).Invoke();

        Assert.That(Player.Logs.Single().Message, Does.Contain("Listener.Nowhere"));
    }

    [Test]
    public void Invoke_ListenerThrows_ExceptionReachesTheCaller()
    {
        var happened = FromFile<UnityEvent>(Add<Listener>("a"), "Throw", PersistentListenerMode.Void);

        Assert.That(happened.Invoke, Throws.InvalidOperationException.With.Message.EqualTo("heard"));
    }

    static T FromFile<T>(Component target, string method, PersistentListenerMode mode, params (string, object)[] arguments)
        where T : UnityEventBase, new()
    {
        var call = new PersistentCall();
        Set(call, "m_Target", target);
        Set(call, "m_MethodName", method);
        Set(call, "m_Mode", mode);
        foreach (var (name, value) in arguments)
        {
            Set(SerializedFields.Find(typeof(PersistentCall), "m_Arguments").GetValue(call), name, value);
        }

        var made = new T();
        Set(made.Persistent, "m_Calls", new List<PersistentCall> { call });
        return made;
    }

    static void Set(object owner, string name, object value) => SerializedFields.Find(owner.GetType(), name).SetValue(owner, value);

    sealed class Listener : MonoBehaviour
    {
        public void Heard() => Journal.Note("Heard");
        public void HeardInt(int value) => Journal.Note($"HeardInt({value})");
        public void HeardString(string value) => Journal.Note($"HeardString({value})");
        public void HeardBool(bool value) => Journal.Note($"HeardBool({value})");
        public void Throw() => throw new InvalidOperationException("heard");
    }
}
