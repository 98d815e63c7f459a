using System.Reflection;
using NUnit.Framework;
using UnityEngine;
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

    /// <summary>
    /// Disables a component and enables it again as Unity does when it recompiles scripts in play mode: it saves private texts, too, and a text that
    /// is null becomes empty.
    /// </summary>
    public static void Recompile(this MonoBehaviour component)
    {
        component.enabled = false;
        foreach (var field in component.GetType().GetFields(BindingFlags.Instance | BindingFlags.NonPublic))
        {
            var isSaved = field.FieldType == typeof(string) && !field.IsDefined(typeof(NonSerializedAttribute));
            if (isSaved && field.GetValue(component) == null) field.SetValue(component, "");
        }
        component.enabled = true;
    }

    static FieldInfo FieldOf(object target, string field)
    {
        var found = SerializedFields.Find(target.GetType(), field);
        Assert.That(found, Is.Not.Null, target.GetType().Name + " has no serialised field " + field);
        return found;
    }
}
