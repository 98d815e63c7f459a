using Nowpose.Prediction;
using Nowpose.Sync;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Unity.Tests.Editor;

/// <summary>Tests the drop-down lists in the inspector of the session settings. The asset stores the chosen names as strings.</summary>
public sealed class SessionSettingsInspectorTests : EditorFixture
{
    SessionSettingsAsset _settings;

    [SetUp]
    public void SetUp()
    {
        GuiRecorder.Clear();
        _settings = ScriptableObject.CreateInstance<SessionSettingsAsset>();
    }

    [Test]
    public void Inspector_NewAsset_OffersAllPredictorsAndClockEstimators()
    {
        Draw(_settings);

        Assert.That(GuiRecorder.Choices, Is.EqualTo(new[] { Predictors.Names.ToArray(), ClockEstimators.Names.ToArray() }));
        Assert.That(GuiRecorder.Texts, Does.Contain("_predictor: adaptive").And.Contain("_clockEstimator: default"));
    }

    [Test]
    public void Inspector_PredictorChosen_IsSerialisedByItsName()
    {
        GuiRecorder.Choose = "quadratic-h3";

        Draw(_settings);

        Assert.That(_settings.ToSettings().Prediction.Predictor, Is.EqualTo("quadratic-h3"));
        Assert.That(_settings.ToSettings().ClockEstimator, Is.EqualTo(ClockEstimators.Default));
    }

    [Test]
    public void Inspector_UnlistedName_IsKeptUntilAnotherIsChosen()
    {
        Set(_settings, "linear-h4");

        Draw(_settings);

        Assert.That(GuiRecorder.Choices[0], Is.EqualTo(Predictors.Names.Append("linear-h4")));
        Assert.That(GuiRecorder.Texts, Does.Contain("_predictor: linear-h4"));
        Assert.That(_settings.ToSettings().Prediction.Predictor, Is.EqualTo("linear-h4"));
    }

    [Test]
    public void Inspector_AssetsWithDifferentNames_ShowsMixedValuesAndChangesNothing()
    {
        var other = ScriptableObject.CreateInstance<SessionSettingsAsset>();
        Set(other, "cubic");

        Draw(_settings, other);

        Assert.That(GuiRecorder.Texts, Does.Contain("_predictor: —").And.Contain("_clockEstimator: default"));
        Assert.That(_settings.ToSettings().Prediction.Predictor, Is.EqualTo(Predictors.Default));
        Assert.That(other.ToSettings().Prediction.Predictor, Is.EqualTo("cubic"));
    }

    static void Draw(params SessionSettingsAsset[] settings)
    {
        var editor = UnityEditor.Editor.CreateEditor(settings);
        editor.OnInspectorGUI();
        UnityEngine.Object.DestroyImmediate(editor);
    }

    static void Set(SessionSettingsAsset settings, string predictor)
    {
        var serialized = new SerializedObject(settings);
        serialized.FindProperty("_predictor").stringValue = predictor;
        serialized.ApplyModifiedProperties();
    }
}
