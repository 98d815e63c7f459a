using Nowpose.Unity;
using Nowpose.Unity.Messages;
using UnityEditor;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(RenderTimeSource))]
    [CanEditMultipleObjects]
    sealed class RenderTimeSourceEditor : LiveInspector<RenderTimeSource>
    {
        readonly StripChart _renderTime = new StripChart("Render time", "ms");

        protected override void Sample(double time) => _renderTime.Take(time, Target.RenderTime?.TotalMilliseconds);

        protected override void DrawLive()
        {
            EditorGUILayout.LabelField("Source", RenderTimeNames.NameOf(Target.Source));
            _renderTime.Draw();
        }
    }
}
