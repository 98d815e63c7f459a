using Nowpose.Unity.Tests.Engine.Scripts;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Engine.Life;

public sealed class ExceptionTests : PlayerFixture
{
    [TestCase("OnEnable", "Awake OnEnable a.Awake a.OnEnable Start a.Start Update a.Update a.LateUpdate")]
    [TestCase("Start", "Awake OnEnable a.Awake a.OnEnable Start a.Start Update a.Update a.LateUpdate")]
    [TestCase("Update", "Awake OnEnable a.Awake a.OnEnable Start a.Start Update a.Update a.LateUpdate")]
    public void Message_Throws_IsLoggedAndOtherScriptsContinue(string message, string expected)
    {
        Thrower.In = message;
        var thrower = Add<Thrower>("t");
        Add<Recorder>("a");

        Assert.That(Frame(), Is.EqualTo(expected));

        var entry = Player.Logs.Single();
        Assert.That((entry.Type, entry.Message), Is.EqualTo((LogType.Exception, "InvalidOperationException: thrown in " + message)));
        Assert.That(entry.Context, Is.SameAs(thrower));
        Assert.That(entry.Exception.StackTrace, Does.Contain(nameof(Thrower)));
    }

    [Test]
    public void Awake_Throws_LeavesTheScriptDisabled()
    {
        Thrower.In = "Awake";
        var thrower = Add<Thrower>("t");

        Assert.That(thrower.enabled, Is.False);
        Assert.That(Frame(), Is.EqualTo("Awake"));
    }

    [TestCase("OnDisable")]
    [TestCase("OnDestroy")]
    public void OnDisableOrOnDestroy_Throws_ObjectIsStillDestroyed(string message)
    {
        var thrower = Add<Thrower>("t");
        Thrower.In = message;

        UnityEngine.Object.DestroyImmediate(thrower.gameObject);

        Assert.That(thrower == null);
        Assert.That(Player.Logs.Single().Message, Does.Contain(message));
    }
}
