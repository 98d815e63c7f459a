using Nowpose.Unity;
using Nowpose.Unity.Status;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(MrilSession))]
    [CanEditMultipleObjects]
    sealed class MrilSessionEditor : LiveInspector
    {
        readonly StripChart _latency = new StripChart("L_app", "ms");
        readonly StripChart _horizon = new StripChart("Horizon", "ms");
        readonly StripChart _error = new StripChart("Error", "mm");

        readonly StatusTexts _texts = new StatusTexts();

        MrilSession Target => (MrilSession)target;

        protected override void Sample(double time)
        {
            var statistics = Target.Statistics;
            _latency.Take(time, statistics?.ApplicationLatency?.TotalMilliseconds);
            _horizon.Take(time, statistics?.Horizon?.TotalMilliseconds);
            _error.Take(time, statistics?.ErrorMm);
        }

        protected override void DrawLive()
        {
            DrawValues();
            // This is the last control, because the number of controls may differ after a restart and must not change within one event.
            if (GUILayout.Button("Restart session")) Target.Restart();
        }

        void DrawValues()
        {
            var statistics = Target.Statistics;
            _texts.Update(
                statistics, Target.Settings, Target.Robot?.Name, Target.Problem, Target.GetComponentInChildren<BaseAnchor>(true),
                Target.GetComponentInChildren<CellPairing>(true));
            StatusLines.Draw(_texts);
            if (statistics == null) return;
            foreach (var (label, value) in SessionRows.Of(statistics)) EditorGUILayout.LabelField(label, value);
            _latency.Draw();
            _horizon.Draw();
            _error.Draw();
        }
    }
}
