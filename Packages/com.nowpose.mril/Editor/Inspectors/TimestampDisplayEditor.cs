using Nowpose.Editor.Messages;
using Nowpose.Unity;
using Nowpose.Unity.Calibration;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(TimestampDisplay))]
    [CanEditMultipleObjects]
    sealed class TimestampDisplayEditor : LiveInspector<TimestampDisplay>
    {
        const double PeriodSeconds = TimestampDigits.PeriodMs / 1000.0;

        protected override void DrawLive()
        {
            var start = Target.FrameStart;
            EditorGUILayout.LabelField(InspectorTexts.ShownTime, LiveText.Number(start?.SinceEpoch.TotalSeconds % PeriodSeconds, "0.000", " s"));
        }
    }
}
