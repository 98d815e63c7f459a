using Nowpose.Editor.Messages;
using Nowpose.Unity;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(Ghost))]
    [CanEditMultipleObjects]
    sealed class GhostEditor : LiveInspector<Ghost>
    {
        readonly StripChart _gap = new StripChart(InspectorTexts.GhostGap, "mm");

        protected override void Sample(double time) => _gap.Take(time, 1000 * Target.GapMetres);

        protected override void DrawLive() => _gap.Draw();
    }
}
