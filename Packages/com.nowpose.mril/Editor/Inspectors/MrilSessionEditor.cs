using System;
using System.Linq;
using Nowpose.Editor.Messages;
using Nowpose.Unity;
using Nowpose.Unity.Anchoring;
using Nowpose.Unity.Status;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(MrilSession))]
    [CanEditMultipleObjects]
    sealed class MrilSessionEditor : LiveInspector<MrilSession>
    {
        readonly StripChart _latency = new StripChart("L_app", "ms");
        readonly StripChart _horizon = new StripChart("Horizon", "ms");
        readonly StripChart _error = new StripChart("Error", "mm");

        readonly StatusTexts _texts = new StatusTexts();

        readonly DescriptionReader _described = new DescriptionReader();

        protected override void Sample(double time)
        {
            var statistics = Target.Statistics;
            _latency.Take(time, statistics?.ApplicationLatency?.TotalMilliseconds);
            _horizon.Take(time, statistics?.Horizon?.TotalMilliseconds);
            _error.Take(time, statistics?.ErrorMm);
        }

        // Does not offer to change a prefab asset, because Unity can add objects to a prefab only while the prefab is open.
        protected override void DrawAlways()
        {
            if (Application.isPlaying || EditorUtility.IsPersistent(target)) return;
            var model = _described.Of(Target.RobotAsset);
            var rigs = model == null ? Array.Empty<RobotRig>() : CellRobot.RigsWithout(Target, model);
            if (rigs.Count == 0) return;
            var robot = Target.RobotAsset.name;
            var removed = string.Join(", ", CellRobot.RemovedFrom(rigs));
            EditorGUILayout.HelpBox(InspectorTexts.NoLinks(string.Join(", ", rigs.Select(rig => rig.name)), robot, removed), MessageType.Warning);
            if (GUILayout.Button(InspectorTexts.ShowRobot(robot))) CellRobot.Show(Target, model, rigs);
        }

        protected override void DrawLive()
        {
            DrawValues();
            // This is the last control, because the number of controls may differ after a restart and must not change within one event.
            if (GUILayout.Button(InspectorTexts.RestartSession)) Target.Restart();
        }

        void DrawValues()
        {
            var statistics = Target.Statistics;
            _texts.Update(
                statistics, Target.Settings, Target.Robot?.Name, Target.Problem, new SessionBases().WorstOf(Target),
                Target.GetComponentInChildren<CellPairing>(true), Target.Parts, Target.GetComponentInChildren<LatencyNudge>(true));
            StatusLines.Draw(_texts);
            if (statistics == null) return;
            foreach (var (label, value) in SessionRows.Of(statistics)) EditorGUILayout.LabelField(label, value);
            _latency.Draw();
            _horizon.Draw();
            _error.Draw();
        }
    }
}
