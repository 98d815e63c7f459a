using Nowpose.Editor.Messages;
using Nowpose.Unity;
using Nowpose.Unity.Status;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Editor.Inspectors
{
    [CustomEditor(typeof(BodyFollow))]
    [CanEditMultipleObjects]
    sealed class BodyFollowEditor : LiveInspector<BodyFollow>
    {
        protected override void DrawLive()
        {
            var head = Target.Head;
            if (head == null)
            {
                EditorGUILayout.LabelField("Follows", InspectorTexts.NoHead);
                return;
            }
            var position = Target.transform.position;
            var place = AroundHead.Of(position, head.position);
            var aside = Mathf.DeltaAngle(AroundHead.HeadingOf(head.rotation), place.Azimuth);
            EditorGUILayout.LabelField("Follows", InspectorTexts.Following(head.name, Target.IsGliding));
            EditorGUILayout.LabelField(
                InspectorTexts.BesideView, LiveText.Number(Mathf.Abs(aside), "0", aside < 0 ? InspectorTexts.DegreesLeft : InspectorTexts.DegreesRight));
            EditorGUILayout.LabelField(InspectorTexts.FromHead, LiveText.Number(Vector3.Distance(position, head.position), "0.00", " m"));
        }
    }
}
