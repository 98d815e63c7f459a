using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(LoadSweep))]
    [CanEditMultipleObjects]
    sealed class LoadSweepEditor : LiveInspector
    {
        protected override void DrawLive()
        {
            var sweep = (LoadSweep)target;
            EditorGUILayout.LabelField("Progress", sweep.Problem ?? sweep.Words ?? LiveText.Unknown);
            EditorGUILayout.LabelField("Log", sweep.Path ?? LiveText.Unknown);
        }
    }
}
