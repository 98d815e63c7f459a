using System;
using System.Reflection.Emit;
using System.Security.Authentication;
using NUnit.Framework;
using UnityEngine;

static class Faults
{
    public static void NewerThanUnitysNUnit()
    {
        Assert.That(new[] { 1 }, Has.Exactly(1).EqualTo(1));
        Assert.That(new[] { 1 }, Has.Exactly(1).Items); // refused
        Assert.Multiple(() => { }); // refused
    }

    public static int ObsoleteInTheNewestUnity(GameObject some)
    {
        some.name = "";
        return some.GetInstanceID(); // refused
    }

    public static GameObject WithCollider() => GameObject.CreatePrimitive(PrimitiveType.Cube); // refused

    public static SslProtocols VersionOfTls(bool isKnown) => isKnown
        ? SslProtocols.Tls12
        : SslProtocols.None; // refused

    public static object MadeAtRunTime(Type element)
    {
        var method = new DynamicMethod("", typeof(void), null); // refused
        return method.Name.Length > 0 ? method.Name : typeof(Action<>).MakeGenericType(element); // refused
    }
}
