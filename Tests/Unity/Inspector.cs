using System.Reflection;
using NUnit.Framework;
using UnityEngine.Serialization;

namespace Nowpose.Unity.Tests;

/// <summary>Sets and gets serialised fields by name, as a user does in the Inspector.</summary>
static class Inspector
{
    public static T With<T>(this T target, string field, object value) where T : class
    {
        FieldOf(target, field).SetValue(target, value);
        return target;
    }

    public static object Shown(this object target, string field) => FieldOf(target, field).GetValue(target);

    static FieldInfo FieldOf(object target, string field)
    {
        var found = SerializedFields.Find(target.GetType(), field);
        Assert.That(found, Is.Not.Null, target.GetType().Name + " has no serialised field " + field);
        return found;
    }
}
