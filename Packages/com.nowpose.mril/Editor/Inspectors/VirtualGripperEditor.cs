using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor
{
    [CustomEditor(typeof(VirtualGripper))]
    [CanEditMultipleObjects]
    sealed class VirtualGripperEditor : LiveInspector
    {
        protected override void DrawLive()
        {
            var gripper = (VirtualGripper)target;
            EditorGUILayout.LabelField("Rides on", gripper.Flange == null ? LiveText.Unknown : gripper.Flange.name);
        }
    }
}
