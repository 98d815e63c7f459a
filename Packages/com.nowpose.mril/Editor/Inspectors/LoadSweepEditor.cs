using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(LoadSweep))]
    [CanEditMultipleObjects]
    sealed class LoadSweepEditor : LiveInspector<LoadSweep>
    {
        protected override void DrawLive()
        {
            EditorGUILayout.LabelField("Progress", Target.Problem ?? Target.Words ?? LiveText.Unknown);
            EditorGUILayout.LabelField("Log", Target.Path ?? LiveText.Unknown);
        }
    }
}
