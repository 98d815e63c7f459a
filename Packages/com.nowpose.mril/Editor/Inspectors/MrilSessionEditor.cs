using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor
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
            var statistics = Target.Statistics;
            _texts.Update(statistics, Target.Settings, Target.Robot?.Name, Target.Problem);
            for (var row = StatusRow.Pose; row < StatusRow.Message; row++)
                EditorGUILayout.LabelField(StatusTexts.LabelOf(row), Joined(_texts.ValueOf(row), _texts.NoteOf(row)));
            if (_texts.ValueOf(StatusRow.Message).Length > 0) EditorGUILayout.HelpBox(_texts.ValueOf(StatusRow.Message), MessageType.Warning);
            if (statistics == null) return;
            foreach (var (label, value) in SessionRows.Of(statistics)) EditorGUILayout.LabelField(label, value);
            _latency.Draw();
            _horizon.Draw();
            _error.Draw();
        }

        static string Joined(string value, string note) => note.Length == 0 ? value : value + ", " + note;
    }
}
