using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(RobotRig))]
    [CanEditMultipleObjects]
    sealed class RobotRigEditor : LiveInspector<RobotRig>
    {
        readonly DescriptionReader _described = new DescriptionReader();
        string _refusal;

        protected override void DrawLive()
        {
            var model = Target.Model;
            EditorGUILayout.LabelField("Robot", model == null ? LiveText.Unknown : model.Name);
            EditorGUILayout.LabelField("State", Target.Fault ?? "current");
            if (model == null) return;
            for (var i = 0; i < Target.Joints.Length; i++)
                EditorGUILayout.LabelField(model.MovingJoints[i].Name, LiveText.Position(model.MovingJoints[i], Target.Joints[i]));
        }

        // Offers to create the robot's objects if they do not exist yet. Does not offer this for a prefab asset, because Unity can add objects to a
        // prefab only while the prefab is open.
        protected override void DrawAlways()
        {
            if (Application.isPlaying || EditorUtility.IsPersistent(target)) return;
            var description = Description();
            if (description == null) return;
            var model = _described.Of(description);
            if (model != null && Target.HasLinksOf(model)) return;
            if (_refusal != null) EditorGUILayout.HelpBox(_refusal, MessageType.Warning);
            if (GUILayout.Button("Build '" + description.name + "' here")) Build(description);
        }

        // A robot in a namespace has its own description; the session's own robot has that of the session.
        RobotDescriptionAsset Description()
        {
            if (Target.RobotNamespace.Length > 0)
                return serializedObject.FindProperty("_description").objectReferenceValue as RobotDescriptionAsset;
            var session = serializedObject.FindProperty("_session").objectReferenceValue as MrilSession;
            if (session == null) session = Target.gameObject.GetComponentInParent<MrilSession>(true);
            return session == null ? null : session.RobotAsset;
        }

        void Build(RobotDescriptionAsset description)
        {
            _refusal = null;
            try
            {
                var root = Target.BuildToStay(description.Read(), PackageAsset.Hologram.Load<Material>());
                Undo.RegisterCreatedObjectUndo(root, "Build " + description.name);
            }
            catch (InputException fault)
            {
                _refusal = fault.Message;
            }
        }
    }
}
