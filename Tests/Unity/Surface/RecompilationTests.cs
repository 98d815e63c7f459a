using System.Reflection;
using Nowpose.Unity.Tests.Manual;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Surface;

/// <summary>Tests what Unity saves of the components when it recompiles scripts in play mode.</summary>
public class RecompilationTests
{
    const BindingFlags Private = BindingFlags.DeclaredOnly | BindingFlags.Instance | BindingFlags.NonPublic;

    // Unity also saves private texts without [SerializeField], and a text that is null becomes empty: a component without a problem would then state
    // an empty one.
    [Test]
    public void Components_PrivateTexts_AreNotSaved()
    {
        var texts = InspectedType.All.SelectMany(SerialisedNames.WithBases).Distinct()
            .SelectMany(type => type.GetFields(Private)).Where(field => field.FieldType == typeof(string)).ToArray();

        var saved = texts.Where(field => !field.IsInitOnly && !field.IsDefined(typeof(NonSerializedAttribute)) && !field.IsDefined(typeof(SerializeField)));

        Assert.That(texts, Is.Not.Empty);
        Assert.That(saved.Select(field => field.DeclaringType.Name + "." + field.Name), Is.Empty, "mark them [NonSerialized]");
    }
}
