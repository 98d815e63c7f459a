using NUnit.Framework;
using UnityEngine.Serialization;

namespace Nowpose.Unity.Tests;

/// <summary>Sets fields like a user in the Inspector.</summary>
static class Inspector
{
    public static T With<T>(this T target, string field, object value) where T : UnityEngine.Object
    {
        var found = SerializedFields.Find(typeof(T), field);
        Assert.That(found, Is.Not.Null, typeof(T).Name + " has no serialised field " + field);
        found.SetValue(target, value);
        return target;
    }
}
