using System;
using System.IO;
using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Shows a summary of a robot description. Its button loads a URDF file into the asset.</summary>
    [CustomEditor(typeof(RobotDescriptionAsset))]
    sealed class RobotDescriptionAssetEditor : UnityEditor.Editor
    {
        UrdfSummary _summary;

        public override void OnInspectorGUI()
        {
            var asset = (RobotDescriptionAsset)target;
            if (_summary == null || !_summary.IsOf(asset)) _summary = new UrdfSummary(asset);
            EditorGUILayout.LabelField("Robot", _summary.Robot);
            EditorGUILayout.LabelField(InspectorTexts.MovingJoints, _summary.Joints);
            EditorGUILayout.LabelField("Characters", _summary.Length);
            EditorGUILayout.LabelField("SHA-256", _summary.Hash);
            if (_summary.Fault != null) EditorGUILayout.HelpBox(_summary.Fault, MessageType.Error);
            // Opens the dialog later, because a dialog would interrupt the drawing of this inspector.
            if (GUILayout.Button(InspectorTexts.LoadUrdf)) EditorApplication.delayCall += Choose;
            EditorGUILayout.HelpBox(_summary.Beginning, MessageType.None);
        }

        void Choose()
        {
            if (target == null) return;
            var path = EditorUtility.OpenFilePanel(InspectorTexts.LoadUrdfTitle, "", "urdf");
            if (string.IsNullOrEmpty(path)) return;
            try
            {
                Load(File.ReadAllText(path));
            }
            catch (Exception e) when (e is IOException || e is UnauthorizedAccessException)
            {
                Debug.LogError(InspectorTexts.UrdfUnreadable(target.name, path, e.Message), target);
            }
        }

        void Load(string urdf)
        {
            serializedObject.Update();
            serializedObject.FindProperty("_urdf").stringValue = urdf;
            serializedObject.ApplyModifiedProperties();
            Repaint();
        }
    }
}
